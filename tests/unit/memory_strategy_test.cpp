// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "support/watched.hpp"
#include "traffic/memory.hpp"

namespace thalweg::testing {
namespace {

constexpr const char* two_ways = R"(
A---B---C
    |   |
    D---E)";

// It changes its way while it waits, and again on the road.
TEST(MemoryStrategyTest, RemembersTheWayOnWhichAVehicleSetOut) {
  Watched traffic(ascii_network(two_ways), 1);
  const Network& net = traffic.network;
  const auto strategy = make_strategy("memory", {});
  traffic.driven.load(0, "ABCE");
  strategy->watch(traffic.look({}, 0));
  traffic.driven.fleet.on_route(VehicleId{0U}, way(net, "ABDE"));
  strategy->watch(traffic.look({}, 5'000));
  strategy->watch(traffic.look({{.vehicle = 0, .road = "AB", .metres = 10}}, 10'000));
  traffic.driven.fleet.on_route(VehicleId{0U}, way(net, "ABCE"));
  strategy->watch(traffic.look({{.vehicle = 0, .road = "AB", .metres = 60}}, 15'000));
  Memory memory;
  strategy->remember(memory);
  ASSERT_EQ(memory.trips.size(), 1U);
  EXPECT_EQ(memory.trips[0].vehicle, "v0");
  EXPECT_EQ(memory.trips[0].route, way(net, "ABDE"));
}

}  // namespace
}  // namespace thalweg::testing
