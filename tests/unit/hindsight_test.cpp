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

TEST_F(HindsightTest, IsWhatThoseThatChangedTookLongerThanThoseThatKeptTheirWay) {
  Hindsight hindsight(100, no_prior);
  EXPECT_EQ(hindsight.disappointment(), 0);
  for (std::uint32_t i = 0; i < 2; ++i) depart(i);
  hindsight.decided(VehicleId{0U}, 0, 100'000, true);
  hindsight.decided(VehicleId{1U}, 0, 100'000, false);
  arrive(1, 110'000, hindsight);
  EXPECT_EQ(hindsight.disappointment(), 0) << "everybody is late, nobody has changed yet";
  arrive(0, 130'000, hindsight);
  EXPECT_NEAR(hindsight.disappointment(), 0.2, 1e-6);
}

TEST_F(HindsightTest, WhoFaredBetterThanForecastIsNoReasonToChangeMore) {
  Hindsight hindsight(100, no_prior);
  depart(0);
  hindsight.decided(VehicleId{0U}, 0, 100'000, true);
  arrive(0, 50'000, hindsight);
  EXPECT_EQ(hindsight.disappointment(), 0);
}

TEST_F(HindsightTest, TheLastChangeCountsElseTheFirstDecision) {
  Hindsight hindsight(100, no_prior);
  for (std::uint32_t i = 0; i < 2; ++i) depart(i);
  hindsight.decided(VehicleId{0U}, 0, 100'000, true);
  hindsight.decided(VehicleId{0U}, 50'000, 150'000, true);
  hindsight.decided(VehicleId{0U}, 60'000, 999'000, false);
  hindsight.decided(VehicleId{1U}, 0, 100'000, false);
  hindsight.decided(VehicleId{1U}, 60'000, 999'000, false);
  arrive(1, 100'000, hindsight);
  arrive(0, 200'000, hindsight);  // 150 s instead of 100
  EXPECT_NEAR(hindsight.disappointment(), 0.5, 1e-6);
}

TEST_F(HindsightTest, AFewArrivalsSayLittleAndOldOnesAreForgotten) {
  Hindsight hindsight(100, {.memory = 1000, .prior = 9});
  depart(0);
  depart(1);
  hindsight.decided(VehicleId{0U}, 0, 100'000, true);
  arrive(0, 200'000, hindsight);
  EXPECT_NEAR(hindsight.disappointment(), 0.1, 1e-6) << "one in ten was late by 100 %";
  hindsight.observe(driven.fleet, 20'000'000);
  EXPECT_NEAR(hindsight.disappointment(), 0, 1e-6);
}

TEST_F(HindsightTest, WhereThereIsNoWayNothingWasPromised) {
  Hindsight hindsight(100, no_prior);
  depart(0);
  hindsight.decided(VehicleId{0U}, 0, infinity, true);
  arrive(0, 500'000, hindsight);
  EXPECT_EQ(hindsight.disappointment(), 0);
}

}  // namespace
}  // namespace thalweg::testing
