// SPDX-License-Identifier: Apache-2.0
#include "traffic/last_roads.hpp"

#include <algorithm>

namespace thalweg {

LastRoads::LastRoads(std::size_t vehicles, const LastRoadOptions& options)
    : options_(options), fading_(options.memory), stays_(vehicles) {}

void LastRoads::observe(const Fleet& fleet, const Expectation& expected, Millis now) {
  const double fading = fading_.advance(now);
  expected_ *= fading;
  taken_ *= fading;
  // Both its entry and its end are noticed half an interval late, in the mean.
  stays_.settle(fleet, [&](const Stay& stay) {
    expected_ += stay.delay;
    taken_ += std::min(to_seconds(now - stay.since) - stay.crossing, stay.delay + options_.most);
  });
  for (const VehicleId vehicle : fleet.present()) {
    const FleetVehicle& own = fleet[vehicle];
    const bool has_entered = own.state == FleetVehicle::State::running && !own.is_lost && !own.on_junction &&
                             own.position > 0 && own.position + 1 == own.route.size();
    if (!has_entered || stays_.contains(vehicle)) continue;
    const RoadId road = own.route.back();
    if (!expected.servers.leads_on(road)) continue;
    stays_[vehicle] = {.since = now,
                       .crossing = expected.servers.free_flow(road),
                       .delay = std::max(0.0, expected.delay(road, 0))};
  }
}

double LastRoads::share() const {
  return std::clamp((taken_ + options_.first * options_.prior) / (expected_ + options_.prior), 0.0, 1.5);
}

}  // namespace thalweg
