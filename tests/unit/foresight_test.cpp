// SPDX-License-Identifier: Apache-2.0
#include "routing/foresight.hpp"

#include <gtest/gtest.h>

#include "network/read_network.hpp"
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

// The forecast is made every 20 s. Who has left the road earlier than foretold is not on it any more; who is
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

//     A-B-C        150 m roads at 10 m/s. The signal at B shows red for 30 s and green for 30 s to both
//     turns.
//       D
constexpr const char* two_turns = R"(<net>
  <edge id="AB" from="A" to="B"><lane id="AB_0" index="0" length="150" speed="10"/></edge>
  <edge id="BC" from="B" to="C"><lane id="BC_0" index="0" length="150" speed="10"/></edge>
  <edge id="BD" from="B" to="D"><lane id="BD_0" index="0" length="150" speed="10"/></edge>
  <tlLogic id="B" type="static" programID="0" offset="0">
    <phase duration="30" state="rr"/><phase duration="30" state="GG"/></tlLogic>
  <junction id="A" x="0" y="0"/><junction id="B" x="0" y="0"/><junction id="C" x="0" y="0"/>
  <junction id="D" x="0" y="0"/>
  <connection from="AB" to="BC" fromLane="0" toLane="0" tl="B" linkIndex="0" dir="s" state="O"/>
  <connection from="AB" to="BD" fromLane="0" toLane="0" tl="B" linkIndex="1" dir="r" state="O"/>
</net>)";

class ForesightAtASignal : public ::testing::Test {
 protected:
  static constexpr SignalId b{0U};

  ForesightAtASignal() : programme(traffic.network.signals[b].programmes.front()) {
    traffic.programmes = IdVector<SignalId, SignalProgramme>(1);
  }
  /// The programme runs from now on; so many stand at the end of AB.
  void look(std::size_t queue, Millis now, const std::vector<ShownSignal>& following = {}) {
    for (std::size_t i = 0; i < queue; ++i) {
      traffic.driven.load(i, "ABC");
      places_.push_back({.vehicle = i, .road = "AB", .metres = 145});
    }
    const std::vector<SignalId> changed{b};
    traffic.programmes[b] = programme;
    TrafficState state = traffic.look(places_, now);
    if (!foresight) state.changed_signals = changed;
    state.following = following;
    if (!foresight) foresight.emplace(state);
    foresight->watch(state);
  }
  [[nodiscard]] bool counts(const char* id) const {
    return foresight->what_is_shown_counts(road(traffic.network, id));
  }

  Watched traffic{parse_network(two_turns), 18};
  std::optional<Foresight> foresight;
  SignalProgramme programme;

 private:
  std::vector<Driven::At> places_;
};

TEST_F(ForesightAtASignal, WhatItShowsCountsWhereItIsKnown) {
  look(0, 0);
  EXPECT_FALSE(counts("AB")) << "nobody knows when its cycle began";
  foresight.reset();
  programme.cycle_start = 0;
  look(0, 0);
  EXPECT_TRUE(counts("AB"));
  EXPECT_FALSE(counts("BC")) << "nothing leads on from there";
}

TEST_F(ForesightAtASignal, WhatItShowsDoesNotCountInAQueue) {
  programme.cycle_start = 0;
  look(18, 0);
  EXPECT_FALSE(counts("AB"));
}

// It follows the traffic: each phase lasts for 20 s instead of 30, and shows green from 580 to 600 s. Means
// within 2 s of those that count are not taken for others.
TEST_F(ForesightAtASignal, IsKnownByWhatItWasSeenToShow) {
  programme.follows_traffic = true;
  for (Millis now = 0; now < 600'000; now += 5'000) {
    const Millis phase = now / 20'000;
    const std::size_t index = phase % 2 == 0 ? 0 : 1;
    look(0, now, {{.signal = b, .phase = {.index = index, .since = phase * 20'000}}});
  }
  const Servers& servers = foresight->expected().servers;
  const SignalWaits& waits = servers.signal_waits();
  const MovementId turn = servers.find(road(traffic.network, "AB"), road(traffic.network, "BC"));
  ASSERT_TRUE(waits.knows(turn));
  const double mean = waits.mean(turn);
  EXPECT_NEAR(mean, 210.0 / 40, 1.5) << "of 20, 19 .. 1 and twenty times 0";
  EXPECT_NEAR(waits.deviation(turn, 590'000, 0), -mean, 0.5) << "in the middle of the green";
  EXPECT_NEAR(waits.deviation(turn, 610'000, 0), 10 - mean, 2) << "in the middle of the red";
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
