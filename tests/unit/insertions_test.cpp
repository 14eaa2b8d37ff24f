// SPDX-License-Identifier: Apache-2.0
#include "traffic/insertions.hpp"

#include <gtest/gtest.h>

#include "support/queueing.hpp"

namespace thalweg::testing {
namespace {

//     A ==> B      Forty want to go straight on from 0 s, and forty to turn left.
//                  One of the first gets in every 20 s, one of the others every 4 s.
class InsertionsTest : public ::testing::Test {
 protected:
  [[nodiscard]] LaneId line(const char* to) const {
    return insertions.line(road(net, "AB"), *to != 0 ? road(net, to) : RoadId{});
  }
  void wait_in_lines(std::size_t seconds) {
    for (std::size_t i = 0; i < 40; ++i) {
      driven.load(i, "ABC");
      driven.load(40 + i, "ABD");
    }
    for (std::size_t second = 0; second <= seconds; ++second) {
      std::vector<Driven::At> places;
      for (std::size_t i = 0; i < second / 20; ++i)
        places.push_back({.vehicle = i, .road = "AB", .metres = 50, .speed = 9});
      for (std::size_t i = 0; i < second / 4; ++i)
        places.push_back({.vehicle = 40 + i, .road = "AB", .metres = 50, .speed = 9});
      driven.look(places);
      insertions.observe(driven.fleet, static_cast<Millis>(second) * 1000);
    }
  }

  Network net = with_left_lane();
  Servers servers{net};
  Driven driven{net, 80};
  Insertions insertions{net, servers, 80};
};

TEST_F(InsertionsTest, TurnsThatShareALaneShareALine) {
  EXPECT_EQ(line("BC"), line("BE"));
  EXPECT_NE(line("BC"), line("BD"));
  EXPECT_EQ(line(""), line("BC")) << "who stays on the road";
  EXPECT_FALSE(insertions.has_one_line(road(net, "AB")));
  EXPECT_TRUE(insertions.has_one_line(road(net, "BC")));
}

TEST_F(InsertionsTest, NobodyWaitsOnAnEmptyRoad) {
  for (Millis second = 0; second <= 600; ++second) insertions.observe(driven.fleet, second * 1000);
  EXPECT_EQ(insertions.headway(line("BC")), 1) << "on two lanes";
  EXPECT_EQ(insertions.headway(line("BD")), 2);
  EXPECT_FALSE(insertions.wait(line("BC")));
}

TEST_F(InsertionsTest, EachLineIsLearnedWhileSomebodyWaits) {
  wait_in_lines(120);
  EXPECT_NEAR(insertions.headway(line("BC")), 1 + 0.5 * (20 - 1), 0.01);
  EXPECT_NEAR(insertions.headway(line("BD")), 2 + 0.5 * (4 - 2), 0.01);
}

TEST_F(InsertionsTest, WhatWasWaitedIsRemembered) {
  wait_in_lines(60);
  ASSERT_TRUE(insertions.wait(line("BC")));
  EXPECT_EQ(*insertions.wait(line("BC")), (20 + 40 + 60) / 3.0 - 0.5) << "half a second between two looks";
  EXPECT_NEAR(*insertions.wait(line("BD")), 32 - 0.5, 1e-9);
}

}  // namespace
}  // namespace thalweg::testing
