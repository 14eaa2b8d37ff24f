// SPDX-License-Identifier: Apache-2.0
#include "traffic/discharge.hpp"

#include <algorithm>

namespace thalweg {
namespace {

/// s between two insertions while nobody has waited yet.
double usual_headway(const Network& network, const Servers& servers, RoadId road) {
  const Road& own = network.roads[road];
  int lanes = 0;
  for (const LaneId lane : own.lanes()) lanes += servers.carries(lane) ? 1 : 0;
  return 2.0 / std::max(1, lanes);
}

}  // namespace

Discharge::Discharge(const Network& network, const Servers& servers, const Demand& demand,
                     const DischargeOptions& options)
    : servers_(servers),
      options_(options),
      lanes_(network.lanes.size()),
      roads_(network.roads.size()),
      last_(demand.vehicles.size()) {
  for (std::size_t i = 0; i < roads_.size(); ++i) {
    RoadState& road = roads_[RoadId{i}];
    road.usual_headway = usual_headway(network, servers, RoadId{i});
    road.headway = road.usual_headway;
  }
}

void Discharge::observe(const Fleet& fleet, Millis now) {
  if (last_lesson_ < 0) last_lesson_ = now;
  for (const VehicleId vehicle : fleet.present()) {
    const FleetVehicle& own = fleet[vehicle];
    if (own.state == FleetVehicle::State::running) {
      note(vehicle, own);
    } else if (own.depart <= now && !own.route.empty()) {
      if (roads_[own.route.front()].waiting++ == 0) wanted_.push_back(own.route.front());
    }
  }
  for (const LaneId lane : queued_) {
    if (lanes_[lane].queue >= options_.queue) ++lanes_[lane].busy_looks;
    lanes_[lane].queue = 0;
  }
  for (const RoadId road : wanted_) {
    ++roads_[road].busy_looks;
    roads_[road].waiting = 0;
  }
  queued_.clear();
  wanted_.clear();
  ++looks_;
  if (now - last_lesson_ < options_.interval) return;
  learn(to_seconds(now - last_lesson_));
  last_lesson_ = now;
  looks_ = 0;
}

void Discharge::note(VehicleId vehicle, const FleetVehicle& now) {
  if (now.is_lost) return;
  Last& last = last_[vehicle];
  if (!last.seen) ++roads_[now.route[now.position]].inserted;
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
  for (RoadState& road : roads_) {
    if (road.busy_looks == looks_) {
      road.headway += 0.5 * (std::min(60.0, seconds / std::max(1, road.inserted)) - road.headway);
    } else if (road.inserted * road.headway > seconds) {
      road.headway = seconds / road.inserted;
    } else {
      road.headway += 0.1 * (road.usual_headway - road.headway);
    }
    road.inserted = 0;
    road.busy_looks = 0;
  }
}

}  // namespace thalweg
