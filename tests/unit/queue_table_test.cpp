// SPDX-License-Identifier: Apache-2.0
#include "traffic/queue_table.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "support/queueing.hpp"

namespace thalweg::testing {
namespace {

//     A---B---C---D      a lane lets one pass in 2 s; a vehicle a second reaches the end of AB, until 30 s
class QueueTableTest : public ::testing::Test {
 protected:
  QueueTableTest() {
    for (int i = 0; i < 30; ++i)
      passed[lane].push_back({.arrived = static_cast<float>(i), .left = static_cast<float>(2 * i)});
    table.tabulate(servers, discharge, passed, delayed);
  }

  Network net = ascii_network("A---B---C---D");
  Servers servers{net};
  Demand demand;
  Discharge discharge{net, servers, demand};
  RoadId ab = road(net, "AB");
  LaneId lane = net.roads[ab].first_lane;
  IdVector<LaneId, std::vector<Passed>> passed{net.lanes.size()};
  IdVector<RoadId, std::vector<float>> delayed{net.roads.size()};
  QueueTable table{net, 20'000, 60, true};
};

TEST_F(QueueTableTest, WhoComesLaterWaitsLonger) {
  EXPECT_EQ(table.headway(ab), 2);
  EXPECT_NEAR(table.wait(ab, 0), 12, 0.01) << "at 10 s: the one before leaves at 20 s";
  EXPECT_NEAR(table.wait(ab, 1), 30, 0.01) << "at 30 s: the last one leaves at 58 s";
  EXPECT_NEAR(table.wait(ab, 2), 10, 0.01);
  EXPECT_EQ(table.wait(ab, 3), 0);
  EXPECT_EQ(table.wait_after(ab, 39), table.wait(ab, 1));
  EXPECT_EQ(table.wait_after(ab, 1e9), table.wait(ab, 59));
}

TEST_F(QueueTableTest, CountsThoseWhoReachTheEnd) {
  EXPECT_EQ(table.arrivals(ab, 0), 20);
  EXPECT_EQ(table.arrivals(ab, 1), 10);
  EXPECT_EQ(table.arrivals(road(net, "BC"), 0), 0);
}

// Of a road that somebody waited for, those who wanted to go elsewhere count as well.
TEST_F(QueueTableTest, HasTolls) {
  const float before = table.toll(ab, 0);
  EXPECT_GT(before, 0);
  EXPECT_EQ(table.toll(road(net, "BC"), 0), 0);
  delayed[ab] = {5, 15};
  table.tabulate(servers, discharge, passed, delayed);
  EXPECT_GT(table.toll(ab, 0), before);
}

// BC: all end there.
TEST_F(QueueTableTest, ARoadThatNobodyLeavesHasTollsWhileSomebodyWaitsForIt) {
  const RoadId bc = road(net, "BC");
  delayed[bc] = {5, 15};
  table.tabulate(servers, discharge, passed, delayed);
  EXPECT_GT(table.toll(bc, 0), 0);
  delayed[bc] = {};
  table.tabulate(servers, discharge, passed, delayed);
  EXPECT_EQ(table.toll(bc, 0), 0);
}

TEST_F(QueueTableTest, WhoIsStillThereAtTheHorizonLeavesAfterIt) {
  passed[lane].back().left = std::numeric_limits<float>::infinity();
  table.tabulate(servers, discharge, passed, delayed);
  EXPECT_NEAR(table.wait(ab, 1), 1200 + 2 - 30, 0.01);
}

}  // namespace
}  // namespace thalweg::testing
