// SPDX-License-Identifier: Apache-2.0
#include "traffic/last_roads.hpp"

#include <gtest/gtest.h>

#include "support/expecting.hpp"

namespace thalweg::testing {
namespace {

//     A---B---C---D      30 s each. Forty stand at the end of BC for 80 s, so that one who enters BC now and
//                        drives on is to wait for some 50 s behind them.
class LastRoadsTest : public Expecting {
 protected:
  LastRoadsTest() { queues.run(queued(net, std::vector<std::string>(40, "BCD")).fleet, level, 0); }
  /// `count` vehicles end on `last` one after the other, each `seconds` after it is seen there.
  void end_trips(LastRoads& last_roads, const char* way, const char* last, std::size_t count,
                 Millis seconds) {
    const Expectation now_expected = expected(unchanged);
    for (std::size_t i = 0; i < count; ++i) {
      Driven driven(net, count);
      driven.load(i, way);
      driven.look({{.vehicle = i, .road = last, .speed = 5}});
      last_roads.observe(driven.fleet, now_expected, 0);
      last_roads.observe(driven.fleet, now_expected, seconds * 500);
      driven.fleet.on_arrived(VehicleId{i});
      last_roads.observe(driven.fleet, now_expected, seconds * 1000);
    }
  }
};

TEST_F(LastRoadsTest, HalfOfTheDelayIsExpectedBeforeAnythingWasSeen) { EXPECT_EQ(LastRoads(1).share(), 0.5); }

TEST_F(LastRoadsTest, TheShareIsLearnedFromThoseWhoArrive) {
  for (const double share : {0.0, 0.3, 1.0}) {
    LastRoads last_roads(100, {.prior = 1, .memory = 1e9});
    const double delay = expected(unchanged).delay(road(net, "BC"), 0);
    ASSERT_GT(delay, 40);
    end_trips(last_roads, "ABC", "BC", 100, static_cast<Millis>(30 + share * delay));
    EXPECT_NEAR(last_roads.share(), share, 0.03);
  }
}

TEST_F(LastRoadsTest, RoadsThatNobodyDrivesOnFromTeachNothing) {
  LastRoads last_roads(10);
  end_trips(last_roads, "BCD", "CD", 10, 500);
  EXPECT_EQ(last_roads.share(), 0.5);
}

}  // namespace
}  // namespace thalweg::testing
