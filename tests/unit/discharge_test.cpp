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

}  // namespace
}  // namespace thalweg::testing
