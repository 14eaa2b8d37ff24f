// SPDX-License-Identifier: Apache-2.0
#include "routing/hindsight.hpp"

#include <algorithm>
#include <cmath>

namespace thalweg {

Hindsight::Hindsight(std::size_t vehicles, const HindsightOptions& options)
    : options_(options), promises_(vehicles) {}

void Hindsight::decided(VehicleId vehicle, Millis now, Millis old_arrival, Millis new_arrival, bool changed) {
  Promise& promise = promises_[vehicle];
  if (old_arrival >= infinity || (promise.made >= 0 && !changed)) return;
  if (promise.made < 0) open_.push_back(vehicle);
  promise = {.made = now,
             .old_arrival = old_arrival,
             .new_arrival = changed ? new_arrival : old_arrival,
             .changed = changed};
}

void Hindsight::observe(const Fleet& fleet, Millis now) {
  const double fading = std::exp(-to_seconds(now - last_) / options_.memory);
  last_ = now;
  for (Account* account : {&changed_, &kept_}) {
    account->old_way *= fading;
    account->new_way *= fading;
    account->taken *= fading;
    account->arrivals *= fading;
  }
  std::erase_if(open_, [&](VehicleId vehicle) {
    if (fleet[vehicle].state != FleetVehicle::State::away) return false;
    const Promise& promise = promises_[vehicle];
    Account& account = promise.changed ? changed_ : kept_;
    account.old_way += to_seconds(promise.old_arrival - promise.made);
    account.new_way += to_seconds(promise.new_arrival - promise.made);
    account.taken += to_seconds(now - promise.made);
    account.arrivals += 1;
    promises_[vehicle] = {};
    return true;
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
