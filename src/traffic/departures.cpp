// SPDX-License-Identifier: Apache-2.0
#include "traffic/departures.hpp"

#include <algorithm>

namespace thalweg {

void Departures::observe(const Fleet& fleet, Millis now) {
  for (const VehicleId vehicle : fleet.present()) {
    const FleetVehicle& own = fleet[vehicle];
    if (own.depart <= noted_until_ || own.depart > now || own.route.size() < 2) continue;
    recent_.push_back({.time = own.depart, .route = own.route});
  }
  noted_until_ = now;
  while (!recent_.empty() && recent_.front().time < now - 2 * repeated_) recent_.pop_front();
}

void Departures::foresee(const Fleet& fleet, Millis now, Millis until, const Take& take) const {
  Millis loaded_until = now;
  for (const VehicleId vehicle : fleet.present())
    loaded_until = std::max(loaded_until, fleet[vehicle].depart);
  if (known_.empty()) {
    if (repeated_ > 0) repeat(fleet, loaded_until, now, until, take);
    return;
  }
  auto next = std::upper_bound(known_.begin(), known_.end(), loaded_until,
                               [](Millis time, const Departure& departure) { return time < departure.time; });
  for (; next != known_.end() && next->time <= until; ++next) take(next->route, next->time);
}

void Departures::repeat(const Fleet& fleet, Millis loaded_until, Millis now, Millis until,
                        const Take& take) const {
  const auto repeat = [&](Millis departure, const std::vector<RoadId>& route) {
    if (departure <= loaded_until - repeated_ || departure > loaded_until) return;
    for (Millis time = departure + repeated_; time <= until; time += repeated_) {
      if (time > loaded_until) take(route, time);
    }
  };
  for (const Departure& departure : recent_) repeat(departure.time, departure.route);
  for (const VehicleId vehicle : fleet.present()) {  // those that are loaded and will depart count as well
    const FleetVehicle& own = fleet[vehicle];
    if (own.depart > now && own.route.size() >= 2) repeat(own.depart, own.route);
  }
}

}  // namespace thalweg
