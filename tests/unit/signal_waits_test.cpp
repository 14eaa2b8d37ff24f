// SPDX-License-Identifier: Apache-2.0
#include "traffic/signal_waits.hpp"

#include <gtest/gtest.h>

namespace thalweg::testing {
namespace {

constexpr MovementId turn{0};
constexpr MovementId other{1};
constexpr Millis start = 7'000;
constexpr double far_ahead = 100'000;

/// 40 s red, 20 s green: 40, 39 .. 1, 0 .. 0. Mean: 820 / 60 s.
std::vector<std::size_t> red_then_green() {
  std::vector<std::size_t> until(60, 0);
  for (std::size_t second = 0; second < 40; ++second) until[second] = 40 - second;
  return until;
}

class SignalWaitsTest : public ::testing::Test {
 protected:
  SignalWaitsTest() { waits.set(turn, red_then_green(), start); }
  SignalWaits waits{2};
};

TEST_F(SignalWaitsTest, AreThoseOfTheSecondWhenItIsNear) {
  EXPECT_NEAR(waits.mean(turn), 820.0 / 60, 1e-9);
  EXPECT_NEAR(waits.deviation(turn, start + 10'000, 0), 30 - 820.0 / 60, 0.1) << "in the middle of the red";
  EXPECT_NEAR(waits.deviation(turn, start + 10'500, 0), 29.5 - 820.0 / 60, 0.1);
  EXPECT_NEAR(waits.deviation(turn, start + 50'000, 0), -820.0 / 60, 0.1) << "in the middle of the green";
  EXPECT_NEAR(waits.deviation(turn, start + 60'000, 0), 20 - 820.0 / 60, 4)
      << "as it closes: one or the other";
}

TEST_F(SignalWaitsTest, RepeatWithTheCycleAlsoBeforeItsStart) {
  for (const Millis time : {0, 13'700, 45'250}) {
    for (const Millis cycles : {-2, 1, 100}) {
      EXPECT_NEAR(waits.deviation(turn, start + time + cycles * 60'000, 30),
                  waits.deviation(turn, start + time, 30), 1e-6);
    }
  }
}

TEST_F(SignalWaitsTest, AreTheMeanFarAhead) {
  for (Millis time = 0; time < 60'000; time += 1'000) EXPECT_EQ(waits.deviation(turn, time, far_ahead), 0);
}

TEST_F(SignalWaitsTest, AverageToNothingOverACycle) {
  for (const double ahead : {0.0, 17.0, 100.0, 400.0}) {
    double sum = 0;
    for (Millis time = 0; time < 60'000; time += 100) sum += waits.deviation(turn, time, ahead);
    EXPECT_NEAR(sum / 600, 0, 1e-4) << ahead;
  }
}

TEST_F(SignalWaitsTest, LetNobodyPassAndNobodyWaitForLessThanNothing) {
  for (const double ahead : {0.0, 30.0, 120.0, 500.0}) {
    double last = -1e9;
    for (Millis time = 0; time < 180'000; time += 250) {
      const double wait = waits.deviation(turn, time, ahead);
      EXPECT_GE(wait, -waits.mean(turn) - 1e-4);
      EXPECT_GE(to_seconds(time) + wait, last - 1e-4) << time << " s, " << ahead;
      last = to_seconds(time) + wait;
    }
  }
}

TEST_F(SignalWaitsTest, AreUnknownWithoutATable) {
  EXPECT_FALSE(waits.knows(other));
  EXPECT_FALSE(waits.knows(MovementId{}));
  EXPECT_EQ(waits.mean(other), 0);
  waits.set(other, std::vector<std::size_t>(60, 60), start);
  EXPECT_FALSE(waits.knows(other)) << "never opens";
  waits.set(other, std::vector<std::size_t>(60, 0), start);
  EXPECT_FALSE(waits.knows(other)) << "is always open: nothing to know";
  waits.set(turn, {}, start);
  EXPECT_FALSE(waits.knows(turn));
}

TEST_F(SignalWaitsTest, FollowANewProgramme) {
  waits.set(other, red_then_green(), start);
  waits.set(turn, red_then_green(), start + 30'000);
  EXPECT_EQ(waits.deviation(turn, start + 30'000, 10), waits.deviation(other, start, 10));
}

}  // namespace
}  // namespace thalweg::testing
