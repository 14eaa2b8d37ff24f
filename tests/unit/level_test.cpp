// SPDX-License-Identifier: Apache-2.0
#include "traffic/level.hpp"

#include <gtest/gtest.h>

#include "support/queueing.hpp"

namespace thalweg::testing {
namespace {

constexpr LevelOptions no_prior{.prior = 1e-6};

//     A-B-------C-D      100 m, 800 m and 100 m at 10 m/s; D ends the world
class LevelTest : public ::testing::Test {
 protected:
  /// A look at every road: ten vehicles that need so many s to cross it.
  void drive(const std::vector<std::pair<const char*, double>>& times) {
    std::vector<Observation> seen;
    for (const auto& [id, seconds] : times) {
      const double length = net.lanes[net.roads[road(net, id)].first_lane].length;
      seen.insert(seen.end(), 10, {.road = road(net, id), .speed = length / seconds});
    }
    for (int second = 0; second < 180; ++second) measured.sample(seen);
  }

  Network net = ascii_network("A-B-C-D", {.roads = {{"BC", {.length = 800}}}});
  Servers servers{net};
  QueueTable nobody{net, 20'000, 60};
  MeasuredTimes measured{net, 180'000, 1'000};
};

TEST_F(LevelTest, IsFreeFlowUntilSomethingWasSeen) {
  Level level(net, no_prior);
  level.learn(servers, nobody, measured, 15);
  EXPECT_EQ(level.pace(), 1);
  EXPECT_EQ(level.extra(servers, road(net, "AB")), 0);
}

// Everybody needs a tenth longer than free flow, and 3 s more at the end of each road.
TEST_F(LevelTest, TellsAPaceFromATimeAtEveryRoadEnd) {
  drive({{"AB", 10 * 1.1 + 3}, {"BC", 80 * 1.1 + 3}});
  Level level(net, no_prior);
  level.learn(servers, nobody, measured, 15);
  EXPECT_NEAR(level.pace(), 1.1, 0.001);
  EXPECT_NEAR(level.extra(servers, road(net, "AB")), 4, 0.02);
  EXPECT_NEAR(level.extra(servers, road(net, "CD")), 4, 0.02) << "where nobody was seen as well";
}

TEST_F(LevelTest, LittleTrafficSaysLittle) {
  drive({{"AB", 10 * 1.1 + 3}, {"BC", 80 * 1.1 + 3}});
  Level level(net, {.prior = 1e6});
  level.learn(servers, nobody, measured, 15);
  EXPECT_NEAR(level.pace(), 1, 0.01);
  EXPECT_NEAR(level.extra(servers, road(net, "AB")), 0, 0.1);
}

// A jam on BC of 20 minutes is no level.
TEST_F(LevelTest, AJamCountsOnlyAsMuchAsALevelCouldBe) {
  drive({{"AB", 10}, {"BC", 1200}});
  Level level(net, {.prior = 1e-6, .most_deviation = 20});
  level.learn(servers, nobody, measured, 15);
  EXPECT_LE(level.extra(servers, road(net, "BC")), 20.5);
}

}  // namespace
}  // namespace thalweg::testing
