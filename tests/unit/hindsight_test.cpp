// SPDX-License-Identifier: Apache-2.0
#include "routing/hindsight.hpp"

#include <gtest/gtest.h>

#include "support/queueing.hpp"

namespace thalweg::testing {
namespace {

constexpr HindsightOptions no_prior{.memory = 1e9, .prior = 0};

//     A-B
class HindsightTest : public ::testing::Test {
 protected:
  /// On the road from time 0 on.
  void depart(std::uint32_t vehicle) {
    driven.load(vehicle, "AB");
    driven.fleet.on_departed(VehicleId{vehicle});
  }
  void arrive(std::uint32_t vehicle, Millis time, Hindsight& hindsight) {
    driven.fleet.on_arrived(VehicleId{vehicle});
    hindsight.observe(driven.fleet, time);
  }

  Network net = ascii_network("A-B");
  Driven driven{net, 100};
};

// 100 s forecast on the old way, 60 on the new. Everybody is a tenth late, so the old way had taken 110: of
// the 40 s promised to the one that changed, 110 - 90 = 20 came true.
TEST_F(HindsightTest, WhatChangingBroughtIsHeldAgainstThoseThatKeptTheirWay) {
  Hindsight hindsight(100, no_prior);
  EXPECT_EQ(hindsight.realised(), no_prior.first) << "nobody has arrived yet";
  EXPECT_NEAR(hindsight.caution(), no_prior.unseen * (1 - 0.3 / 0.5), 1e-6);
  for (std::uint32_t i = 0; i < 2; ++i) depart(i);
  hindsight.decided(VehicleId{0U}, 0, 100'000, 60'000, true);
  hindsight.decided(VehicleId{1U}, 0, 100'000, 100'000, false);
  arrive(0, 90'000, hindsight);
  EXPECT_NEAR(hindsight.realised(), 0.25, 1e-6) << "nobody else has arrived yet";
  arrive(1, 110'000, hindsight);
  EXPECT_NEAR(hindsight.realised(), 0.5, 1e-6);
  EXPECT_EQ(hindsight.caution(), 0) << "that is enough";
}

TEST_F(HindsightTest, WhereChangingBringsNothingAGainMustExceedWhatWasPromisedInVain) {
  Hindsight hindsight(100, no_prior);
  depart(0);
  hindsight.decided(VehicleId{0U}, 0, 100'000, 60'000, true);
  arrive(0, 100'000, hindsight);
  EXPECT_NEAR(hindsight.realised(), 0, 1e-6);
  EXPECT_NEAR(hindsight.caution(), 0.4, 1e-6);
}

TEST_F(HindsightTest, InBetweenItIsAPartOfThat) {
  Hindsight hindsight(100, no_prior);
  depart(0);
  hindsight.decided(VehicleId{0U}, 0, 100'000, 60'000, true);
  arrive(0, 90'000, hindsight);
  EXPECT_NEAR(hindsight.caution(), 0.5 * 0.3, 1e-6) << "a quarter is half of enough; 30 of 100 s were missed";
}

TEST_F(HindsightTest, TheLastChangeCountsElseTheFirstDecision) {
  Hindsight hindsight(100, no_prior);
  for (std::uint32_t i = 0; i < 2; ++i) depart(i);
  hindsight.decided(VehicleId{0U}, 0, 500'000, 100'000, true);
  hindsight.decided(VehicleId{0U}, 50'000, 250'000, 150'000, true);
  hindsight.decided(VehicleId{0U}, 60'000, 999'000, 999'000, false);
  hindsight.decided(VehicleId{1U}, 0, 100'000, 100'000, false);
  hindsight.decided(VehicleId{1U}, 60'000, 999'000, 999'000, false);
  arrive(1, 100'000, hindsight);
  arrive(0, 200'000, hindsight);  // 150 s; the last change promised 100 instead of 200
  EXPECT_NEAR(hindsight.realised(), 0.5, 1e-6);
}

TEST_F(HindsightTest, AFewArrivalsSayLittleAndOldOnesAreForgotten) {
  Hindsight hindsight(100, {.memory = 1000, .first = 0.5, .prior = 9});
  depart(0);
  depart(1);
  hindsight.decided(VehicleId{0U}, 0, 100'000, 60'000, true);
  arrive(0, 100'000, hindsight);
  EXPECT_NEAR(hindsight.realised(), 0.45, 1e-6) << "one in ten had nothing of it";
  hindsight.decided(VehicleId{1U}, 10'000'000, 10'100'000, 10'060'000, true);
  arrive(1, 10'060'000, hindsight);
  EXPECT_NEAR(hindsight.realised(), (9 * 0.5 + 1) / 10, 1e-3) << "what the second was promised came true";
}

// By another way of the same length: it changed for the others' sake.
TEST_F(HindsightTest, WhoWasPromisedNothingIsNotDisappointed) {
  Hindsight hindsight(100, {});
  depart(0);
  hindsight.decided(VehicleId{0U}, 0, 100'000, 100'000, true);
  arrive(0, 150'000, hindsight);
  EXPECT_EQ(hindsight.realised(), HindsightOptions{}.first);
  EXPECT_EQ(hindsight.caution(), 0);
}

TEST_F(HindsightTest, WhereThereIsNoWayNothingWasPromised) {
  Hindsight hindsight(100, no_prior);
  depart(0);
  hindsight.decided(VehicleId{0U}, 0, infinity, 100'000, true);
  arrive(0, 500'000, hindsight);
  EXPECT_EQ(hindsight.realised(), no_prior.first);
}

}  // namespace
}  // namespace thalweg::testing
