// SPDX-License-Identifier: Apache-2.0
#include "traffic/lived_times.hpp"

#include <gtest/gtest.h>

#include "support/ascii_network.hpp"

namespace thalweg::testing {
namespace {

//     A-B-C      100 m each, junctions of 20 m; bins of a minute
class Lived : public ::testing::Test {
 protected:
  /// One look after the other, a second apart, at one vehicle.
  void drive(const char* id, double speed, int seconds) {
    const Observation vehicle[] = {{.road = road(net, id), .speed = speed}};
    for (int i = 0; i < seconds; ++i) lived.look(vehicle, now += 1'000);
  }
  void stay_away(int seconds) {
    for (int i = 0; i < seconds; ++i) lived.look({}, now += 1'000);
  }

  Network net = ascii_network("A-B-C", {.junction_metres = 20});
  LivedTimes lived{net, 60'000};
  Millis now = -1'000;
};

TEST_F(Lived, ATimeIsVehicleSecondsByTraversals) {
  stay_away(1);
  drive("AB", 5, 20);  // once through, at half of the limit
  drive("BC", 10, 5);  // half of the road
  const auto day = lived.take();
  ASSERT_EQ(day.size(), 1U);
  ASSERT_EQ(day[0].size(), 2U);
  EXPECT_EQ(day[0][0].road, road(net, "AB"));
  EXPECT_DOUBLE_EQ(day[0][0].seconds, 20);
  EXPECT_DOUBLE_EQ(day[0][0].observations, 1);
  EXPECT_EQ(day[0][1].road, road(net, "BC"));
  EXPECT_DOUBLE_EQ(day[0][1].seconds, 10) << "what half a traversal tells of a whole one";
}

TEST_F(Lived, EachBinIsItsOwn) {
  stay_away(31);
  drive("AB", 10, 10);
  stay_away(140);
  drive("AB", 5, 15);
  const auto day = lived.take();
  ASSERT_EQ(day.size(), 4U);
  EXPECT_DOUBLE_EQ(day[0].at(0).seconds, 10);
  EXPECT_TRUE(day[1].empty());
  EXPECT_TRUE(day[2].empty());
  EXPECT_DOUBLE_EQ(day[3].at(0).seconds, 20);
}

TEST_F(Lived, WhoJustComesInTellsNothingAndWhoStandsTellsMuch) {
  stay_away(1);
  drive("AB", 10, 3);
  drive("BC", 0, 40);
  const auto day = lived.take();
  ASSERT_EQ(day[0].size(), 1U);
  EXPECT_EQ(day[0][0].road, road(net, "BC"));
  EXPECT_DOUBLE_EQ(day[0][0].seconds, 80) << "40 s, as if it had come half the way";
}

}  // namespace
}  // namespace thalweg::testing
