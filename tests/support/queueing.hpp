// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

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

/// A vehicle a way, given by its junctions, at the end of its first road.
inline Driven queued(const Network& network, const std::vector<std::string>& ways) {
  Driven driven(network, ways.size());
  std::vector<std::string> roads;
  roads.reserve(ways.size());
  for (const std::string& junctions : ways) roads.push_back(junctions.substr(0, 2));
  std::vector<Driven::At> places;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    driven.load(i, ways[i]);
    places.push_back({.vehicle = i, .road = roads[i].c_str(), .metres = 299});
  }
  driven.look(places);
  return driven;
}

/// `count` vehicles at the end of AB, bound for D.
inline Driven crowded(const Network& network, std::size_t count) {
  return queued(network, std::vector<std::string>(count, "ABCD"));
}

/// Three minutes in which ten vehicles drive on this road at 3 m/s.
inline MeasuredTimes slow_road(const Network& network, const char* id) {
  MeasuredTimes measured(network, 180'000, 1'000);
  for (int second = 0; second < 180; ++second)
    measured.sample(std::vector<Observation>(10, {.road = road(network, id), .speed = 3}));
  return measured;
}

}  // namespace thalweg::testing
