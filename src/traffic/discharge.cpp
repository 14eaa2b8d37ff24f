// SPDX-License-Identifier: Apache-2.0
#include "traffic/discharge.hpp"

#include <algorithm>

namespace thalweg {
Discharge::Discharge(const Network& network, const Servers& servers, const Demand& demand,
                     const DischargeOptions& options)
    : servers_(servers),
      options_(options),
      insertions_(network, servers, demand.vehicles.size()),
      lanes_(network.lanes.size()),
      last_(demand.vehicles.size()) {}

void Discharge::observe(const Fleet& fleet, Millis now) {
  insertions_.observe(fleet, now);
  if (last_lesson_ < 0) last_lesson_ = now;
  for (const VehicleId vehicle : fleet.present()) {
    if (fleet[vehicle].state == FleetVehicle::State::running) note(vehicle, fleet[vehicle]);
  }
  for (const LaneId lane : queued_) {
    if (lanes_[lane].queue >= options_.queue) ++lanes_[lane].busy_looks;
    lanes_[lane].queue = 0;
  }
  queued_.clear();
  ++looks_;
  if (now - last_lesson_ < options_.interval) return;
  learn(to_seconds(now - last_lesson_));
  last_lesson_ = now;
  looks_ = 0;
}

void Discharge::note(VehicleId vehicle, const FleetVehicle& now) {
  if (now.is_lost) return;
  Last& last = last_[vehicle];
  const bool left = last.seen && !last.on_junction && (now.on_junction || now.position != last.position);
  if (left && last.lane.valid()) {
    const std::size_t next = now.position == last.position ? now.position + 1 : last.position + 1;
    // After a change of route the roads behind may have other positions: then nothing is learned from it.
    if (next < now.route.size()) {
      const MovementId movement = servers_.find(last.road, now.route[next]);
      if (movement.valid()) lanes_[last.lane].served += servers_[movement].headway;
    }
  }
  if (!now.on_junction && now.lane.valid() && now.speed < options_.slow) {
    if (lanes_[now.lane].queue++ == 0) queued_.push_back(now.lane);
  }
  last = {.position = now.position,
          .on_junction = now.on_junction,
          .seen = true,
          .lane = now.lane,
          .road = now.route[now.position]};
}

void Discharge::learn(double seconds) {
  for (LaneState& lane : lanes_) {
    if (lane.busy_looks == looks_) {
      const double seen = lane.served > 0 ? seconds / lane.served : options_.most;
      lane.factor +=
          options_.towards_slower * (std::clamp(seen, options_.least, options_.most) - lane.factor);
    } else if (lane.served * lane.factor > seconds) {
      lane.factor +=
          options_.towards_faster * (std::max(options_.least, seconds / lane.served) - lane.factor);
    }
    lane.served = 0;
    lane.busy_looks = 0;
  }
}

}  // namespace thalweg
