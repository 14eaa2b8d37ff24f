// SPDX-License-Identifier: Apache-2.0
#include "network/lane_targets.hpp"

#include <gtest/gtest.h>

#include "support/queueing.hpp"

namespace thalweg::testing {
namespace {

TEST(LaneTargets, OnlyLanesForOneTurnHaveOne) {
  const Network net = with_left_lane();
  const auto targets = lane_targets(net);
  const Road& ab = net.roads[road(net, "AB")];
  EXPECT_FALSE(targets[ab.lane(0)].road.valid()) << "straight on or right";
  EXPECT_EQ(targets[ab.lane(1)].road, road(net, "BC"));
  EXPECT_EQ(targets[ab.lane(1)].lane, net.roads[road(net, "BC")].first_lane);
  EXPECT_EQ(targets[ab.lane(2)].road, road(net, "BD"));
  EXPECT_FALSE(targets[net.roads[road(net, "BC")].lane(0)].road.valid()) << "nowhere";
}

}  // namespace
}  // namespace thalweg::testing
