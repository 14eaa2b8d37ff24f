// SPDX-License-Identifier: Apache-2.0
#include "traffic/fleet.hpp"

#include <algorithm>

namespace thalweg {

Fleet::Fleet(const Demand& demand) : vehicles_(demand.vehicles.size()) {
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    vehicles_[VehicleId{i}].depart = demand.vehicles[VehicleId{i}].depart.value_or(0);
  }
}

void Fleet::on_loaded(VehicleId vehicle, std::span<const RoadId> route, Millis now) {
  FleetVehicle& own = vehicles_[vehicle];
  if (own.state == FleetVehicle::State::away) present_.push_back(vehicle);
  own.state = FleetVehicle::State::waiting;
  own.depart = std::max(own.depart, now);
  own.route.assign(route.begin(), route.end());
}

void Fleet::on_departed(VehicleId vehicle) {
  if (vehicles_[vehicle].state == FleetVehicle::State::waiting)
    vehicles_[vehicle].state = FleetVehicle::State::running;
}

void Fleet::on_arrived(VehicleId vehicle) {
  FleetVehicle& own = vehicles_[vehicle];
  if (own.state == FleetVehicle::State::away) return;
  own = {};
  ++gone_;
}

void Fleet::on_route(VehicleId vehicle, std::span<const RoadId> rest) {
  FleetVehicle& own = vehicles_[vehicle];
  own.route.resize(std::min(own.position, own.route.size()));
  own.route.insert(own.route.end(), rest.begin(), rest.end());
}

void Fleet::on_plan(VehicleId vehicle, std::span<const RoadId> rest) {
  const FleetVehicle& own = vehicles_[vehicle];
  const auto ahead =
      own.route.begin() + static_cast<std::ptrdiff_t>(std::min(own.position, own.route.size()));
  const auto known = std::find(ahead, own.route.end(), rest.front());
  if (!std::equal(known, own.route.end(), rest.begin(), rest.end())) on_route(vehicle, rest);
}

void Fleet::on_observed(const Network& network, std::span<const Observation> observations) {
  forget_gone();
  entered_.clear();
  for (const VehicleId vehicle : present_) vehicles_[vehicle].is_lost = true;
  for (const Observation& seen : observations) {
    if (!seen.vehicle.valid()) continue;
    FleetVehicle& own = vehicles_[seen.vehicle];
    own.speed = seen.speed;
    own.on_junction = network.roads[seen.road].function != RoadFunction::normal;
    own.is_lost = false;
    if (own.on_junction) continue;
    const auto ahead =
        own.route.begin() + static_cast<std::ptrdiff_t>(std::min(own.position, own.route.size()));
    const auto found = std::find(ahead, own.route.end(), seen.road);
    own.is_lost = found == own.route.end();
    if (own.is_lost) continue;
    const auto position = static_cast<std::size_t>(found - own.route.begin());
    if (position != own.position || !own.lane.valid()) entered_.push_back(seen.vehicle);
    own.position = position;
    own.lane = seen.lane;
    own.metres = seen.position;
  }
}

void Fleet::forget_gone() {
  if (gone_ == 0) return;
  std::erase_if(present_,
                [&](VehicleId vehicle) { return vehicles_[vehicle].state == FleetVehicle::State::away; });
  gone_ = 0;
}

}  // namespace thalweg
