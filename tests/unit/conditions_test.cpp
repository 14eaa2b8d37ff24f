// SPDX-License-Identifier: Apache-2.0
#include "traffic/conditions.hpp"

#include <gtest/gtest.h>

#include "support/ascii_network.hpp"

namespace thalweg::testing {
namespace {

//     A---B---C      300 m at 10 m/s each
class ConditionsTest : public ::testing::Test {
 protected:
  [[nodiscard]] LaneChange change(const char* id, Millis begin, Millis end) const {
    return {.lane = net.roads[road(net, id)].first_lane, .begin = begin, .end = end};
  }
  Network net = ascii_network("A---B---C");
  RoadId first = road(net, "AB");
};

TEST_F(ConditionsTest, ARoadIsClosedFromBeginUntilBeforeEnd) {
  LaneChange closing = change("AB", 5'000, 9'000);
  closing.permissions = Permissions::none();
  Conditions conditions(net, {closing});
  EXPECT_FALSE(conditions.advance(4'999));
  EXPECT_FALSE(conditions.closed(first, VehicleClass::passenger));
  EXPECT_TRUE(conditions.advance(5'000));
  EXPECT_TRUE(conditions.closed(first, VehicleClass::passenger));
  EXPECT_FALSE(conditions.advance(8'999)) << "nothing is new";
  EXPECT_TRUE(conditions.advance(9'000));
  EXPECT_FALSE(conditions.closed(first, VehicleClass::passenger));
}

TEST_F(ConditionsTest, AClosingMayBeForSomeClasses) {
  LaneChange closing = change("AB", 0, infinity);
  closing.permissions = Permissions::none();
  closing.permissions.add(VehicleClass::bus);
  Conditions conditions(net, {closing});
  conditions.advance(0);
  EXPECT_TRUE(conditions.closed(first, VehicleClass::passenger));
  EXPECT_FALSE(conditions.closed(first, VehicleClass::bus));
  EXPECT_FALSE(conditions.closed(road(net, "BC"), VehicleClass::passenger));
}

TEST_F(ConditionsTest, ASpeedSignHoldsUntilItsNextStep) {
  LaneChange slow = change("AB", 0, 10'000);
  slow.speed = 2;
  Conditions conditions(net, {slow});
  ASSERT_EQ(conditions.roads().size(), 1U);
  EXPECT_EQ(conditions.roads()[0], first);
  conditions.advance(0);
  EXPECT_DOUBLE_EQ(conditions.crossing(first), 150);
  conditions.advance(10'000);
  EXPECT_DOUBLE_EQ(conditions.crossing(first), 30);
}

}  // namespace
}  // namespace thalweg::testing
