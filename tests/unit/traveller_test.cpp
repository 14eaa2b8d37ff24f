// SPDX-License-Identifier: Apache-2.0
#include "simulation/traveller.hpp"

#include <gtest/gtest.h>

#include "support/ascii_network.hpp"

namespace thalweg::testing {
namespace {

// A-B-C-D-E    100 m roads at 10 m/s
class Travellers : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<VertexId> vertices(const char* roads) const {
    std::vector<VertexId> result;
    for (const RoadId road : way(net, roads)) result.push_back(graph.vertex(road));
    return result;
  }

  Network net = ascii_network("A-B-C-D-E");
  RoadGraph graph{net, VehicleClass::passenger};
};

TEST_F(Travellers, DecideFromTheFirstRoadWhoseNextTurnIsFree) {
  const auto found = make_traveller({.route = way(net, "ABCDE"), .committed = 2, .driven = 0.5}, {}, graph);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->route, vertices("BCDE"));
  EXPECT_EQ(found->driven, 0) << "it is not on that road yet";
  EXPECT_EQ(found->waypoints, vertices("DE"));
}

TEST_F(Travellers, WhoIsWhereItWantsToBeHasNothingToDecide) {
  EXPECT_FALSE(make_traveller({.route = way(net, "ABC"), .committed = 2}, {}, graph));
}

TEST_F(Travellers, HaveNoWayPointsBehindThem) {
  const Plan plan{.route = way(net, "ABCDE"), .committed = 2, .stops = way(net, "BCD")};
  const auto found = make_traveller(plan, {}, graph);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->waypoints, vertices("CDE"));
}

TEST_F(Travellers, AreSoFarFromTheirFreeTurn) {
  RoadTimes times(net.roads.size(), 10'000);
  EXPECT_EQ(until_free_turn({.route = way(net, "ABCDE"), .driven = 0.3}, 0, times), -3'000);
  EXPECT_EQ(until_free_turn({.route = way(net, "ABCDE"), .committed = 3, .driven = 0.3}, 0, times), 17'000);
  EXPECT_EQ(until_free_turn({.route = way(net, "ABCDE")}, 60'000, times), 60'000) << "it is not there yet";
}

}  // namespace
}  // namespace thalweg::testing
