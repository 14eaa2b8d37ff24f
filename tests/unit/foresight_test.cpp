// SPDX-License-Identifier: Apache-2.0
#include "routing/foresight.hpp"

#include <gtest/gtest.h>

#include "support/watched.hpp"

namespace thalweg::testing {
namespace {

//     A-B-C-D      300 m roads at 10 m/s: 30 s; a lane lets one pass in 2 s
class ForesightTest : public ::testing::Test {
 protected:
  void look(const std::vector<Driven::At>& places, Millis now) {
    const TrafficState state = traffic.look(places, now);
    if (!foresight) foresight.emplace(state);
    foresight->watch(state);
  }

  Watched traffic{ascii_network("A---B---C---D"), 3};
  std::optional<Foresight> foresight;
};

TEST_F(ForesightTest, SaysWhenAVehicleLeavesTheRoadItIsOn) {
  for (std::size_t i = 0; i < 2; ++i) traffic.driven.load(i, "ABCD");
  look({{.vehicle = 0, .road = "AB", .metres = 300}, {.vehicle = 1, .road = "AB", .metres = 200}}, 0);
  const auto second = foresight->leaving(VehicleId{1U});
  ASSERT_TRUE(second);
  EXPECT_EQ(second->road, road(traffic.network, "AB"));
  EXPECT_EQ(second->at, 10'000);
  EXPECT_FALSE(foresight->leaving(VehicleId{2U})) << "it is not there";
}

// The forecast is made every 15 s. Who has left the road earlier than foretold is not on it any more; who is
// still there though it should have left leaves now.
TEST_F(ForesightTest, SaysNothingOfARoadThatIsBehind) {
  for (std::size_t i = 0; i < 2; ++i) traffic.driven.load(i, "ABCD");
  look({{.vehicle = 0, .road = "AB", .metres = 200}, {.vehicle = 1, .road = "AB", .metres = 270}}, 0);
  look({{.vehicle = 0, .road = "BC", .metres = 5}, {.vehicle = 1, .road = "AB", .metres = 300}}, 12'000);
  EXPECT_EQ(foresight->forecast_at(), 0) << "no new forecast yet";
  EXPECT_FALSE(foresight->leaving(VehicleId{0U}));
  ASSERT_TRUE(foresight->leaving(VehicleId{1U}));
  EXPECT_EQ(foresight->leaving(VehicleId{1U})->at, 12'000);
}

// Twenty wait to go straight on, and none of them gets on AB. The left turn takes as long, until two were
// seen to get in for it after 10 and 20 s.
TEST(ForesightOfInsertions, CountsOnAnotherLineWhenItWasSeenToBeFaster) {
  Watched traffic(with_left_lane(), 22);
  const auto road_of = [&](const char* id) { return road(traffic.network, id); };
  for (std::size_t i = 0; i < 20; ++i) traffic.driven.load(i, "ABC");
  const TrafficState first = traffic.look({}, 0);
  Foresight foresight(first);
  foresight.watch(first);
  const auto wait = [&](const char* second) {
    return foresight.insertion(VehicleId{19U}, 0, road_of("AB"), road_of(second));
  };
  EXPECT_EQ(wait("BC"), 19'000);
  EXPECT_EQ(wait("BE"), 19'000) << "the same line";
  EXPECT_EQ(wait("BD"), 19'000) << "nobody knows";
  for (std::size_t i = 20; i < 22; ++i) traffic.driven.load(i, "ABD");
  foresight.watch(traffic.look({{.vehicle = 20, .road = "AB"}}, 10'000));
  foresight.watch(traffic.look({{.vehicle = 20, .road = "AB"}, {.vehicle = 21, .road = "AB"}}, 20'000));
  EXPECT_EQ(wait("BC"), 19'000) << "by the new forecast";
  EXPECT_EQ(wait("BD"), 0) << "it has waited for longer than those";
}

}  // namespace
}  // namespace thalweg::testing
