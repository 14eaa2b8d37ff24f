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
  EXPECT_FALSE(targets[ab.lane(0)].valid()) << "straight on or right";
  EXPECT_EQ(targets[ab.lane(1)], road(net, "BC"));
  EXPECT_EQ(targets[ab.lane(2)], road(net, "BD"));
  EXPECT_FALSE(targets[net.roads[road(net, "BC")].lane(0)].valid()) << "nowhere";
}

}  // namespace
}  // namespace thalweg::testing
