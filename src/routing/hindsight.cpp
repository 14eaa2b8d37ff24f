// SPDX-License-Identifier: Apache-2.0
#include "routing/hindsight.hpp"

#include <algorithm>
#include <cmath>

namespace thalweg {

Hindsight::Hindsight(std::size_t vehicles, const HindsightOptions& options)
    : options_(options), promises_(vehicles) {}

void Hindsight::decided(VehicleId vehicle, Millis now, Millis predicted_arrival, bool changed) {
  Promise& promise = promises_[vehicle];
  if (predicted_arrival >= infinity || (promise.made >= 0 && !changed)) return;
  if (promise.made < 0) open_.push_back(vehicle);
  promise = {.made = now, .arrival = predicted_arrival, .changed = changed};
}

void Hindsight::observe(const Fleet& fleet, Millis now) {
  const double fading = std::exp(-to_seconds(now - last_) / options_.memory);
  last_ = now;
  for (Account* account : {&changed_, &kept_}) {
    account->promised *= fading;
    account->taken *= fading;
    account->arrivals *= fading;
  }
  std::erase_if(open_, [&](VehicleId vehicle) {
    if (fleet[vehicle].state != FleetVehicle::State::away) return false;
    const Promise& promise = promises_[vehicle];
    Account& account = promise.changed ? changed_ : kept_;
    account.promised += to_seconds(promise.arrival - promise.made);
    account.taken += to_seconds(now - promise.made);
    account.arrivals += 1;
    promises_[vehicle] = {};
    return true;
  });
}

double Hindsight::Account::ratio(double prior) const {
  if (promised <= 0) return 1;
  const double kept_promises = prior * promised / arrivals;
  return (taken + kept_promises) / (promised + kept_promises);
}

double Hindsight::disappointment() const {
  return std::max(0.0, changed_.ratio(options_.prior) - kept_.ratio(options_.prior));
}

}  // namespace thalweg
