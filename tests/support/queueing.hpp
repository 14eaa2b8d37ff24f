// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "network/read_network.hpp"
#include "support/ascii_network.hpp"
#include "traffic/discharge.hpp"
#include "traffic/fleet.hpp"
#include "traffic/servers.hpp"

namespace thalweg::testing {

///     A ==3 lanes==> B --> C     from the two at the kerb
///                    B --> E     from the first as well
///                    B --> D     from the third, which leads nowhere else
inline Network with_left_lane() {
  return parse_network(R"(<net>
  <edge id="AB" from="A" to="B"><lane id="AB_0" index="0" length="300" speed="10"/>
    <lane id="AB_1" index="1" length="300" speed="10"/><lane id="AB_2" index="2" length="300" speed="10"/></edge>
  <edge id="BC" from="B" to="C"><lane id="BC_0" index="0" length="300" speed="10"/></edge>
  <edge id="BD" from="B" to="D"><lane id="BD_0" index="0" length="300" speed="10"/></edge>
  <edge id="BE" from="B" to="E"><lane id="BE_0" index="0" length="300" speed="10"/></edge>
  <junction id="A" x="0" y="0"/><junction id="B" x="0" y="0"/><junction id="C" x="0" y="0"/>
  <junction id="D" x="0" y="0"/><junction id="E" x="0" y="0"/>
  <connection from="AB" to="BE" fromLane="0" toLane="0" dir="r" state="M"/>
  <connection from="AB" to="BC" fromLane="0" toLane="0" dir="s" state="M"/>
  <connection from="AB" to="BC" fromLane="1" toLane="0" dir="s" state="M"/>
  <connection from="AB" to="BD" fromLane="2" toLane="0" dir="l" state="M"/>
</net>)");
}

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
