// SPDX-License-Identifier: Apache-2.0
#include "traffic/discharge.hpp"

#include <gtest/gtest.h>

#include "support/queueing.hpp"

namespace thalweg::testing {
namespace {

//     A-B-C
class DischargeTest : public ::testing::Test {
 protected:
  [[nodiscard]] LaneId lane() const { return net.roads[road(net, "AB")].first_lane; }
  Network net = ascii_network("A-B-C");
  Servers servers{net};
};

// A queue of four at every look; one leaves every `gap` s, where the model says 2 s.
TEST_F(DischargeTest, AStandingQueueShowsTheCapacity) {
  for (const int gap : {1, 2, 6}) {
    Driven driven(net, 200);
    Discharge discharge(net, servers, driven.demand);
    std::size_t left = 0;
    for (std::size_t i = 0; i < 200; ++i) driven.load(i, "ABC");
    for (Millis second = 0; second <= 120; ++second) {
      if (second > 0 && second % gap == 0) ++left;
      std::vector<Driven::At> places;
      if (left > 0) places.push_back({.vehicle = left - 1, .road = "BC", .metres = 1, .speed = 9});
      for (std::size_t i = left; i < left + 4; ++i)
        places.push_back({.vehicle = i, .road = "AB", .metres = 90});
      driven.look(places);
      discharge.observe(driven.fleet, second * 1000);
    }
    const double shown = gap / 2.0;
    EXPECT_NEAR(discharge.factor(lane()), 1 + 0.3 * (std::max(0.6, shown) - 1), 0.02) << gap;
  }
}

TEST_F(DischargeTest, AnEmptyRoadTeachesNothing) {
  Driven driven(net, 1);
  Discharge discharge(net, servers, driven.demand);
  for (Millis second = 0; second <= 600; ++second) discharge.observe(driven.fleet, second * 1000);
  EXPECT_EQ(discharge.factor(lane()), 1);
}

//     A --> M --> N      who comes from B gives way
//           ^
//           B
constexpr const char* side_road = R"(<net>
  <edge id="AM" from="A" to="M"><lane id="AM_0" index="0" length="300" speed="10"/></edge>
  <edge id="BM" from="B" to="M"><lane id="BM_0" index="0" length="300" speed="10"/></edge>
  <edge id="MN" from="M" to="N"><lane id="MN_0" index="0" length="300" speed="10"/></edge>
  <junction id="A" x="0" y="0"/><junction id="B" x="0" y="0"/><junction id="M" x="0" y="0"/>
  <junction id="N" x="0" y="0"/>
  <connection from="AM" to="MN" fromLane="0" toLane="0" dir="s" state="M"/>
  <connection from="BM" to="MN" fromLane="0" toLane="0" dir="r" state="m"/>
</net>)";

// Three stand on either road for two minutes, and none of them leaves.
TEST(DischargeOfASideRoad, IsSoonBelievedToBeNextToNothing) {
  const Network net = parse_network(side_road);
  const Servers servers(net);
  const Driven driven = queued(net, {"AMN", "AMN", "AMN", "BMN", "BMN", "BMN"});
  Discharge discharge(net, servers, driven.demand);
  for (Millis second = 0; second <= 120; ++second) discharge.observe(driven.fleet, second * 1000);
  const auto factor = [&](const char* id) { return discharge.factor(net.roads[road(net, id)].first_lane); };
  EXPECT_NEAR(factor("AM"), 1 + 0.3 * (4 - 1), 1e-9);
  EXPECT_NEAR(factor("BM"), 1 + 0.6 * (15 - 1), 1e-9);
}

}  // namespace
}  // namespace thalweg::testing
