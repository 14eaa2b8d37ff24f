// SPDX-License-Identifier: Apache-2.0
#include "traffic/measured.hpp"

#include <gtest/gtest.h>

#include "support/ascii_network.hpp"

namespace thalweg::testing {
namespace {

//     A-B-C      100 m each, limit 10 m/s: 10 s
class Measured : public ::testing::Test {
 protected:
  Millis live(const MeasuredTimes& measured, const char* id) const {
    RoadTimes times;
    measured.live(free_flow, times);
    return times[road(net, id)];
  }
  [[nodiscard]] Observation at(const char* id, double speed) const {
    return {.road = road(net, id), .speed = speed};
  }

  Network net = ascii_network("A-B-C");
  RoadTimes free_flow = limit_times(net);
};

TEST_F(Measured, NothingSeenIsFreeFlow) {
  const MeasuredTimes measured(net, 4'000, 1'000);
  RoadTimes times;
  measured.live(free_flow, times);
  EXPECT_EQ(times, free_flow);
}

// Four samples: 2 m/s; the mean of 1 and 3 m/s; empty, so the limit of 10; 6 m/s. Their mean is 5 m/s.
TEST_F(Measured, AveragesTheWindowAndAnEmptyRoadCountsItsLimit) {
  MeasuredTimes measured(net, 4'000, 1'000);
  const Observation first[] = {at("AB", 2)};
  const Observation second[] = {at("AB", 1), at("BC", 10), at("AB", 3)};
  const Observation last[] = {at("AB", 6)};
  measured.sample(first);
  measured.sample(second);
  measured.sample({});
  measured.sample(last);
  EXPECT_EQ(live(measured, "AB"), 100'000 / 5);
  EXPECT_EQ(live(measured, "BC"), 10'000);
  EXPECT_EQ(live(measured, "BA"), 10'000);
}

// Before the window is full, what was not yet seen counts as empty: one of four samples at 2 m/s gives
// (2 + 3 x 10) / 4 = 8 m/s.
TEST_F(Measured, BeginsAsAnEmptyRoad) {
  MeasuredTimes measured(net, 4'000, 1'000);
  const Observation slow[] = {at("AB", 2)};
  measured.sample(slow);
  EXPECT_EQ(live(measured, "AB"), 12'500);
}

TEST_F(Measured, ForgetsExactlyAfterTheWindow) {
  MeasuredTimes measured(net, 4'000, 1'000);
  const Observation slow[] = {at("AB", 0.333)};
  measured.sample(slow);
  const Millis seen = live(measured, "AB");
  EXPECT_GT(seen, 10'000);
  for (int i = 0; i < 3; ++i) measured.sample({});
  EXPECT_EQ(live(measured, "AB"), seen) << "still within the window";
  measured.sample({});
  EXPECT_EQ(live(measured, "AB"), 10'000);
}

TEST_F(Measured, TheWindowIsASpanOfTimeNotANumberOfSamples) {
  MeasuredTimes measured(net, 4'000, 2'000);
  const Observation slow[] = {at("AB", 2)};
  measured.sample(slow);
  EXPECT_EQ(live(measured, "AB"), 100'000 / 6) << "one of two samples";
  measured.sample({});
  measured.sample({});
  EXPECT_EQ(live(measured, "AB"), 10'000);
}

TEST_F(Measured, IsNeverBelowFreeFlow) {
  MeasuredTimes measured(net, 2'000, 1'000);
  const Observation racing[] = {at("AB", 30), at("BC", 9)};
  measured.sample(racing);
  measured.sample(racing);
  EXPECT_EQ(live(measured, "AB"), 10'000);
  EXPECT_EQ(live(measured, "BC"), 100'000 / 9);
  // A class that drives 5 m/s at most is slower than that anyway.
  const RoadTimes moped = free_flow_times(net, VehicleClass::moped, 5, {});
  RoadTimes times;
  measured.live(moped, times);
  EXPECT_EQ(times[road(net, "BC")], 20'000);
}

TEST_F(Measured, StandingTrafficIsSlowNotClosed) {
  MeasuredTimes measured(net, 2'000, 1'000);
  const Observation standing[] = {at("AB", 0)};
  measured.sample(standing);
  measured.sample(standing);
  EXPECT_EQ(live(measured, "AB"), 100'000'000) << "100 m at 1 mm/s";
}

TEST_F(Measured, VehiclesThatAreNowhereDoNotCount) {
  MeasuredTimes measured(net, 1'000, 1'000);
  const Observation teleporting[] = {{.road = RoadId{}, .speed = 0}, at("AB", 5)};
  measured.sample(teleporting);
  EXPECT_EQ(live(measured, "AB"), 20'000);
}

TEST(MeasuredInternal, InternalRoadsAreMeasuredToo) {
  const Network net = ascii_network("A-B-C", {.junction_metres = 20});
  MeasuredTimes measured(net, 1'000, 1'000);
  const RoadGraph graph(net, VehicleClass::passenger);
  const RoadId internal = graph.junction_roads(ArcId{0U}).front();
  const Observation slow[] = {{.road = internal, .speed = 1}};
  measured.sample(slow);
  RoadTimes times;
  measured.live(limit_times(net), times);
  EXPECT_EQ(times[internal], 20'000);
}

TEST(MeasuredClosed, AClosedRoadStaysClosed) {
  const Network net = ascii_network("A-B", {.roads = {{"AB", {.speed = 0}}}});
  MeasuredTimes measured(net, 1'000, 1'000);
  const Observation odd[] = {{.road = road(net, "AB"), .speed = 1}, {.road = road(net, "BA"), .speed = 0}};
  measured.sample(odd);
  RoadTimes times;
  measured.live(limit_times(net), times);
  EXPECT_EQ(times[road(net, "AB")], infinity);
}

}  // namespace
}  // namespace thalweg::testing
