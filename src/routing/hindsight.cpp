// SPDX-License-Identifier: Apache-2.0
#include "routing/hindsight.hpp"

#include <algorithm>

namespace thalweg {

Hindsight::Hindsight(std::size_t vehicles, const HindsightOptions& options)
    : options_(options), fading_(options.memory), promises_(vehicles) {}

void Hindsight::decided(VehicleId vehicle, Millis now, Millis old_arrival, Millis new_arrival, bool changed) {
  if (old_arrival >= infinity || (promises_.contains(vehicle) && !changed)) return;
  promises_[vehicle] = {.made = now,
                        .old_arrival = old_arrival,
                        .new_arrival = changed ? new_arrival : old_arrival,
                        .changed = changed};
}

void Hindsight::observe(const Fleet& fleet, Millis now) {
  const double fading = fading_.advance(now);
  for (Account* account : {&changed_, &kept_}) {
    account->old_way *= fading;
    account->new_way *= fading;
    account->taken *= fading;
    account->arrivals *= fading;
  }
  promises_.settle(fleet, [&](const Promise& promise) {
    Account& account = promise.changed ? changed_ : kept_;
    account.old_way += to_seconds(promise.old_arrival - promise.made);
    account.new_way += to_seconds(promise.new_arrival - promise.made);
    account.taken += to_seconds(now - promise.made);
    account.arrivals += 1;
  });
}

double Hindsight::Account::ratio(double prior) const {
  if (arrivals <= 0) return 1;
  const double as_promised = prior * new_way / arrivals;
  return (taken + as_promised) / (new_way + as_promised);
}

double Hindsight::realised() const {
  const double promised = changed_.promised();
  if (promised <= 0) return options_.first;
  const double gained = kept_.ratio(options_.prior) * changed_.old_way - changed_.taken;
  const double as_promised = options_.prior * promised / changed_.arrivals;
  return (gained + options_.first * as_promised) / (promised + as_promised);
}

double Hindsight::caution() const {
  const bool has_seen = changed_.arrivals > 0;
  if (has_seen && changed_.promised() <= 0) return 0;  // ways that are as long: nobody can be disappointed
  const double share = realised();
  if (share >= options_.enough) return 0;
  const double disappointment =
      has_seen ? (1 - share) * changed_.promised() / changed_.old_way : options_.unseen;
  return disappointment * std::min(1.0, 1 - share / options_.enough);
}

}  // namespace thalweg
