// SPDX-License-Identifier: Apache-2.0
#include "traffic/phase_lengths.hpp"

#include <gtest/gtest.h>

#include <array>

namespace thalweg::testing {
namespace {

// G 30 s, y 3 s, r 30 s, written down; each green lasts as long as somebody comes.
SignalProgramme programme() {
  return {.id = "0",
          .type = "actuated",
          .offset = 0,
          .phases = {{.duration = 30'000, .state = "G"},
                     {.duration = 3'000, .state = "y"},
                     {.duration = 30'000, .state = "r"}},
          .cycle_start = {},
          .follows_traffic = true};
}

class PhaseLengthsTest : public ::testing::Test {
 protected:
  /// Looked at every five seconds, for so many cycles of these lengths; no look need be in the yellow.
  void run(int cycles, std::array<Millis, 3> lengths) {
    for (int cycle = 0; cycle < cycles; ++cycle) {
      for (std::size_t phase = 0; phase < 3; ++phase) {
        for (; next_look_ < time_ + lengths[phase]; next_look_ += 5'000)
          seen.see({.index = phase, .since = time_}, next_look_);
        time_ += lengths[phase];
      }
    }
  }
  [[nodiscard]] std::array<double, 3> lengths() const {
    std::array<double, 3> result{};
    for (std::size_t i = 0; i < 3; ++i) result[i] = to_seconds(seen.programme().phases[i].duration);
    return result;
  }

  PhaseLengths seen{programme()};

 private:
  Millis time_ = 0;
  Millis next_look_ = 2'000;
};

TEST_F(PhaseLengthsTest, AreThoseWrittenDownUntilOthersAreSeen) {
  EXPECT_FALSE(seen.take_means(2'000));
  run(10, {30'000, 3'000, 30'000});
  EXPECT_FALSE(seen.take_means(2'000));
  EXPECT_EQ(lengths(), (std::array<double, 3>{30, 3, 30}));
}

TEST_F(PhaseLengthsTest, BecomeThoseThatAreSeen) {
  run(40, {7'000, 3'000, 16'000});
  EXPECT_TRUE(seen.take_means(2'000));
  EXPECT_EQ(lengths(), (std::array<double, 3>{7, 3, 16}));
  EXPECT_FALSE(seen.take_means(2'000));
}

TEST_F(PhaseLengthsTest, TheCycleBeginsSoThatThePhaseIsWhereItShows) {
  seen.see({.index = 2, .since = 100'000}, 110'000);
  EXPECT_EQ(*seen.programme().cycle_start, 100'000 - 33'000);
  seen.see({.index = 2, .since = 100'000}, 170'000);
  EXPECT_EQ(*seen.programme().cycle_start, 170'000 - 62'000)
      << "it is overdue: in the last second of the phase";
}

// Green again and again: the red in between came and went unseen, or was left out.
TEST_F(PhaseLengthsTest, WhatCannotBeIsNotLearned) {
  for (Millis since = 0; since < 500'000; since += 10'000)
    seen.see({.index = 0, .since = since}, since + 1'000);
  seen.see({.index = 2, .since = 491'000}, 492'000);  // one second of green, and three of yellow
  EXPECT_FALSE(seen.take_means(2'000));
  seen.see({.index = 7, .since = 495'000}, 497'000);  // no such phase
  EXPECT_EQ(*seen.programme().cycle_start, 492'000 - 1'000 - 33'000);
}

}  // namespace
}  // namespace thalweg::testing
