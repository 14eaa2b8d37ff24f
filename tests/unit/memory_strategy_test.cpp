// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "routing/strategy.hpp"
#include "support/queueing.hpp"
#include "traffic/memory.hpp"

namespace thalweg::testing {
namespace {

//     A---B---C
//         |   |
//         D---E
class MemoryStrategyTest : public ::testing::Test {
 protected:
  void look(const std::vector<Driven::At>& places, Millis now) {
    driven.look(places);
    strategy->watch({.now = now,
                     .network = net,
                     .demand = driven.demand,
                     .fleet = driven.fleet,
                     .measured = measured,
                     .observations = {},
                     .conditions = conditions,
                     .programmes = programmes,
                     .changed_signals = {}});
  }

  Network net = ascii_network(
      "A---B---C\n"
      "    |   |\n"
      "    D---E");
  Driven driven{net, 1};
  MeasuredTimes measured{net, 180'000, 3'000};
  Conditions conditions{net};
  IdVector<SignalId, SignalProgramme> programmes;
  std::unique_ptr<Strategy> strategy = make_strategy("memory", {});
};

// It changes its way while it waits, and again on the road.
TEST_F(MemoryStrategyTest, RemembersTheWayOnWhichAVehicleSetOut) {
  driven.load(0, "ABCE");
  look({}, 0);
  driven.fleet.on_route(VehicleId{0U}, way(net, "ABDE"));
  look({}, 5'000);
  look({{.vehicle = 0, .road = "AB", .metres = 10}}, 10'000);
  driven.fleet.on_route(VehicleId{0U}, way(net, "ABCE"));
  look({{.vehicle = 0, .road = "AB", .metres = 60}}, 15'000);
  Memory memory;
  strategy->remember(memory);
  ASSERT_EQ(memory.trips.size(), 1U);
  EXPECT_EQ(memory.trips[0].vehicle, "v0");
  EXPECT_EQ(memory.trips[0].route, way(net, "ABDE"));
}

}  // namespace
}  // namespace thalweg::testing
