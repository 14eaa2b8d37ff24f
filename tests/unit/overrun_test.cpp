// SPDX-License-Identifier: Apache-2.0
#include "traffic/overrun.hpp"

#include <gtest/gtest.h>

#include "support/queueing.hpp"

namespace thalweg::testing {
namespace {

class OverrunTest : public ::testing::Test {
 protected:
  /// A thousand vehicles; each is foretold 100 or 300 s and takes what `taken` says of that.
  template <class Taken>
  void drive(const Taken& taken) {
    for (std::size_t i = 0; i < 1000; ++i) {
      const Millis foretold = i % 2 == 0 ? 100'000 : 300'000;
      const VehicleId vehicle{i};
      driven.load(i, "ABC");
      overrun.predicted(vehicle, now, now + foretold, false);
      driven.fleet.on_arrived(vehicle);
      now += taken(foretold);
      overrun.observe(driven.fleet, now);
    }
  }

  Network net = ascii_network("A-B-C");
  Driven driven{net, 1001};
  Overrun overrun{1001, {.memory = 1e9, .prior = 100, .most = 10, .most_share = 0.6}};
  Millis now = 0;
};

TEST_F(OverrunTest, IsNothingUntilSomebodyHasArrived) {
  driven.load(0, "ABC");
  overrun.predicted(VehicleId{0U}, 0, 50'000, false);
  overrun.observe(driven.fleet, 90'000);
  EXPECT_EQ(overrun.later(100'000), 0);
}

// A tenth of what was foretold and 5 s on top: 15 and 35 s late. A hundred that came true are counted in.
TEST_F(OverrunTest, IsATimeAndAShare) {
  drive([](Millis foretold) { return foretold + foretold / 10 + 5'000; });
  EXPECT_NEAR(to_seconds(overrun.later(100'000)), 15 / 1.1, 0.1);
  EXPECT_NEAR(to_seconds(overrun.later(300'000)), 35 / 1.1, 0.1);
}

TEST_F(OverrunTest, AJamCountsForNoMoreThanItMay) {
  drive([](Millis foretold) { return foretold + 1'000'000; });
  EXPECT_NEAR(to_seconds(overrun.later(100'000)), 70 / 1.1, 0.1);
}

TEST_F(OverrunTest, NobodyArrivesBeforeNow) {
  drive([](Millis foretold) { return foretold / 2; });
  EXPECT_NEAR(to_seconds(overrun.later(300'000)), -150 / 1.1, 0.1);
  EXPECT_GE(overrun.later(100), -100);
}

TEST_F(OverrunTest, WhatWasForetoldOfAnotherWayIsMoot) {
  driven.load(0, "ABC");
  overrun.predicted(VehicleId{0U}, 0, 20'000, false);
  overrun.predicted(VehicleId{0U}, 10'000, 100'000, true);
  driven.fleet.on_arrived(VehicleId{0U});
  overrun.observe(driven.fleet, 100'000);
  EXPECT_EQ(overrun.later(50'000), 0);
}

}  // namespace
}  // namespace thalweg::testing
