// SPDX-License-Identifier: Apache-2.0
#include "traffic/green.hpp"

#include <gtest/gtest.h>

#include <array>

namespace thalweg::testing {
namespace {

constexpr std::array<std::size_t, 1> second_line{1};

/// Link 0 leads onto the road, link 1 off it.
SignalProgramme programme(std::vector<SignalPhase> phases) {
  return {.id = "0", .type = "static", .offset = 0, .phases = std::move(phases)};
}

TEST(Green, CountsEachKindOfLight) {
  const auto p = programme({{.duration = 10'000, .state = "Gr"},
                            {.duration = 3'000, .state = "yg"},
                            {.duration = 20'000, .state = "ss"},
                            {.duration = 7'000, .state = "Oo"}});
  const Green first = green_of(p, 0);
  EXPECT_EQ(first.priority, 10 + 7) << "switched off: who has the right of way, has it";
  EXPECT_EQ(first.yellow, 3);
  EXPECT_EQ(first.permissive, 10) << "a stop, then on: half of it";
  EXPECT_EQ(first.cycle, 40);
  const Green second = green_of(p, 1);
  EXPECT_EQ(second.priority, 0);
  EXPECT_EQ(second.permissive, 3 + 10 + 7);
  EXPECT_EQ(green_of(p, 2).priority, 0) << "the programme has no such link";
}

//    --0-->[ road, 5 s ]--1-->      both links of one signal, cycle 60 s
class Coordinated : public ::testing::Test {
 protected:
  [[nodiscard]] static std::optional<double> wait(const SignalProgramme& p) {
    const std::array<Feeder, 1> feeders{{{.link = 0, .travel = 5}}};
    return coordinated_wait(p, feeders, second_line, 0.5);
  }
};

TEST_F(Coordinated, BothGreenAtOnce) {
  // Who comes in the last 5 of 30 s finds it closed: 30 to 26 s.
  const auto p = programme({{.duration = 30'000, .state = "GG"}, {.duration = 30'000, .state = "rr"}});
  EXPECT_NEAR(*wait(p), (30 + 29 + 28 + 27 + 26) / 30.0, 1e-9);
}

TEST_F(Coordinated, TheSecondOpensFiveSecondsLater) {
  const auto p = programme({{.duration = 5'000, .state = "Gr"},
                            {.duration = 25'000, .state = "GG"},
                            {.duration = 5'000, .state = "rG"},
                            {.duration = 25'000, .state = "rr"}});
  EXPECT_EQ(*wait(p), 0) << "a green wave";
}

TEST_F(Coordinated, OneAfterTheOther) {
  // Entered at 0 .. 29, at its end at 5 .. 34, let go from 30 on.
  const auto p = programme({{.duration = 30'000, .state = "Gr"}, {.duration = 30'000, .state = "rG"}});
  EXPECT_NEAR(*wait(p), (25.0 * 26 / 2) / 30, 1e-9);
}

TEST_F(Coordinated, NothingIsSaidOfALinkThatNeverOpens) {
  EXPECT_FALSE(wait(programme({{.duration = 30'000, .state = "Gr"}})));
  EXPECT_FALSE(wait(programme({{.duration = 30'000, .state = "rG"}})));
  EXPECT_FALSE(wait(programme({})));
}

TEST(SecondsUntilOpen, RunDownToGreenAndBeginAnew) {
  const auto p = programme({{.duration = 2'000, .state = "rG"}, {.duration = 3'000, .state = "Gr"}});
  constexpr std::array<std::size_t, 1> first{0};
  EXPECT_EQ(seconds_until_open(p, first), (std::vector<std::size_t>{2, 1, 0, 0, 0}));
  EXPECT_EQ(seconds_until_open(p, second_line), (std::vector<std::size_t>{0, 0, 3, 2, 1}));
  EXPECT_EQ(seconds_until_open(p, std::array<std::size_t, 2>{0, 1}), std::vector<std::size_t>(5, 0));
  EXPECT_EQ(seconds_until_open(p, std::array<std::size_t, 1>{7}), std::vector<std::size_t>(5, 5)) << "never";
}

TEST(SecondsUntilOpen, AreUnknownWhereThereAreNone) {
  EXPECT_TRUE(seconds_until_open(programme({}), second_line).empty());
  EXPECT_TRUE(seconds_until_open(programme({{.duration = 2'500, .state = "rG"}}), second_line).empty());
}

}  // namespace
}  // namespace thalweg::testing
