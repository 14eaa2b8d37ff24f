// SPDX-License-Identifier: Apache-2.0
#include "traffic/insertions.hpp"

#include <gtest/gtest.h>

#include "support/queueing.hpp"

namespace thalweg::testing {
namespace {

//     A-B-C       Forty want to go straight on from 0 s and forty to turn, all at once. One of the first gets
//     in
//       |         every 20 s, one of the others every 4 s.
//       D
class InsertionsTest : public ::testing::Test {
 protected:
  void wait_in_line(std::size_t seconds) {
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

  Network net = ascii_network("A-B-C\n  |\n  D");
  Servers servers{net};
  MovementId straight_on = servers.find(road(net, "AB"), road(net, "BC"));
  MovementId turn = servers.find(road(net, "AB"), road(net, "BD"));
  Driven driven{net, 80};
  Insertions insertions{servers, 80};
};

TEST_F(InsertionsTest, NobodyWaitsOnAnEmptyRoad) {
  for (Millis second = 0; second <= 600; ++second) insertions.observe(driven.fleet, second * 1000);
  EXPECT_EQ(insertions.headway(straight_on), 2);
  EXPECT_FALSE(insertions.wait(straight_on));
}

TEST_F(InsertionsTest, EachFirstTurnHasALineOfItsOwn) {
  wait_in_line(120);
  EXPECT_NEAR(insertions.headway(straight_on), (120 + 2 * 2) / (6.0 + 2), 1) << "two usual ones, in 2 s each";
  EXPECT_NEAR(insertions.headway(turn), (120 + 2 * 2) / (30.0 + 2), 0.2);
}

TEST_F(InsertionsTest, WhatWasWaitedIsRemembered) {
  wait_in_line(60);
  ASSERT_TRUE(insertions.wait(straight_on));
  EXPECT_EQ(*insertions.wait(straight_on), (20 + 40 + 60) / 3.0 - 0.5) << "half a second between two looks";
  EXPECT_NEAR(*insertions.wait(turn), 32 - 0.5, 1e-9);
}

}  // namespace
}  // namespace thalweg::testing
