// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/ascii_network.hpp"
#include "traffic/discharge.hpp"
#include "traffic/fleet.hpp"
#include "traffic/servers.hpp"

namespace thalweg::testing {

/// A demand of `count` vehicles v0, v1 .. that depart at 0.
inline Demand crowd(std::size_t count) {
  Demand demand;
  for (std::size_t i = 0; i < count; ++i) {
    DemandVehicle vehicle;
    vehicle.id = fmt::format("v{}", i);
    vehicle.depart = 0;
    demand.vehicles.push_back(vehicle);
  }
  return demand;
}

/// A fleet, told step by step where its vehicles are.
struct Driven {
  Driven(const Network& net, std::size_t count) : network(net), demand(crowd(count)), fleet(demand) {}

  void load(std::size_t vehicle, std::string_view junctions, Millis now = 0) {
    fleet.on_loaded(VehicleId{vehicle}, way(network, junctions), now);
  }
  /// One look: each of these stands at `metres` of a road, at this speed.
  struct At {
    std::size_t vehicle;
    const char* road;
    double metres = 0;
    double speed = 0;
  };
  void look(const std::vector<At>& places) {
    std::vector<Observation> seen;
    for (const At& at : places) {
      fleet.on_departed(VehicleId{at.vehicle});
      const RoadId on = road(network, at.road);
      seen.push_back({.road = on,
                      .speed = at.speed,
                      .vehicle = VehicleId{at.vehicle},
                      .lane = network.roads[on].first_lane,
                      .position = at.metres});
    }
    fleet.on_observed(network, seen);
  }

  const Network& network;
  Demand demand;
  Fleet fleet;
};

}  // namespace thalweg::testing
