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

//     side --.                        .-- right
//             >== street, two lanes ==<         street_0 leads to the right only, street_1 to the left
//     main ==´                        `-- left  side leads to street_0 only, main_1 to street_1
TEST(ConditionsTurns, ALaneThatIsBlockedClosesTheTurnsThatNeedIt) {
  const auto edge = [](const std::string& id, const char* from, const char* to, int lanes) {
    std::string text = "<edge id='" + id + "' from='" + from + "' to='" + to + "'>";
    for (int k = 0; k < lanes; ++k) {
      const std::string index = std::to_string(k);
      text += "<lane id='" + id + "_" + index + "' index='" + index + "' speed='10' length='100'/>";
    }
    return text + "</edge>";
  };
  const auto connection = [](const char* from, int from_lane, const char* to, int to_lane) {
    return "<connection from='" + std::string(from) + "' to='" + to + "' fromLane='" +
           std::to_string(from_lane) + "' toLane='" + std::to_string(to_lane) + "' dir='s' state='M'/>";
  };
  std::string text =
      "<net>" + edge("side", "a", "c", 1) + edge("main", "b", "c", 2) + edge("street", "c", "d", 2);
  text += edge("right", "d", "e", 1) + edge("left", "d", "f", 1);
  for (const char* id : {"a", "b", "c", "d", "e", "f"})
    text += "<junction id='" + std::string(id) + "' type='priority' x='0' y='0'/>";
  text += connection("side", 0, "street", 0) + connection("main", 0, "street", 0) +
          connection("main", 1, "street", 1) + connection("street", 0, "right", 0) +
          connection("street", 1, "left", 0) + "</net>";
  const Network net = parse_network(text);
  const RoadGraph graph(net, VehicleClass::passenger);
  const LaneId first = net.roads[road(net, "street")].first_lane;
  const LaneChange blocked{.lane = first, .begin = 5'000, .permissions = Permissions::none()};
  const auto closed = [&](const Conditions& conditions) {
    std::string turns;
    for (const ArcId turn : conditions.closed_turns(graph)) {
      const auto [tail, head] = graph.turns().ends(turn);
      turns += names(net, graph, {tail, head}) + "; ";
    }
    return turns;
  };

  Conditions lane(net, {blocked});
  lane.advance(0);
  EXPECT_EQ(closed(lane), "");
  lane.advance(5'000);
  EXPECT_EQ(closed(lane), "side street; street right; ");

  LaneChange other = blocked;
  other.lane = LaneId{first.value + 1};
  Conditions whole(net, {blocked, other});
  whole.advance(5'000);
  EXPECT_EQ(closed(whole), "side street; main street; ") << "who is on it may leave";
}

}  // namespace
}  // namespace thalweg::testing
