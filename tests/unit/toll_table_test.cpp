// SPDX-License-Identifier: Apache-2.0
#include "traffic/toll_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace thalweg::testing {
namespace {

constexpr std::size_t bins = 60;
constexpr Millis bin = 20'000;

/// A lane that lets one pass in `headway` s, first come, first served.
struct Lane {
  Lane(double between, const std::vector<float>& arrivals) : headway(between) {
    for (const float time : arrivals) {
      const double left = std::max(static_cast<double>(time), last + headway);
      passed.push_back({.arrived = time, .left = static_cast<float>(left)});
      last = left;
    }
    for (std::size_t b = 0; b < bins; ++b) wait.push_back(static_cast<float>(wait_at(middle(b))));
    for (const float time : arrivals) count[static_cast<std::size_t>(time / 20)] += 1;
  }
  static double middle(std::size_t b) { return (static_cast<double>(b) + 0.5) * 20; }
  /// s until one leaves that comes then, those of the same moment before it.
  [[nodiscard]] double wait_at(double time) const {
    double before = -1e9;
    for (const Passed& one : passed) {
      if (one.arrived <= time) before = one.left;
    }
    return std::max(0.0, before + headway - time);
  }
  [[nodiscard]] TollTable tolls() const {
    TollTable table(1, bin, bins);
    table.add(RoadId{0U}, 1,
              {.headway = headway, .delay = 0, .passed = passed, .arrivals = count, .wait = wait});
    return table;
  }
  /// s that all wait, taken together.
  [[nodiscard]] double waiting() const {
    double sum = 0;
    for (const Passed& one : passed) sum += static_cast<double>(one.left) - one.arrived;
    return sum;
  }

  double headway;
  double last = -1e9;
  std::vector<Passed> passed;
  std::vector<float> count = std::vector<float>(bins, 0.0F);
  std::vector<float> wait;
};

std::vector<float> every(double seconds, double until) {
  std::vector<float> times;
  for (double time = 0; time < until; time += seconds) times.push_back(static_cast<float>(time));
  return times;
}

// A vehicle a second until 30 s, and one leaves in 2 s. One that comes at 10 s holds up the 19 behind it, 2 s
// each, the later the less: sum of 2 exp(-i / 300) over i = 0 to 18. One that comes after all holds up
// nobody, and pays only for what a flow of 30 in 180 s costs anyway.
TEST(TollTableTest, WhoJoinsAQueueHoldsUpThoseBehind) {
  const TollTable table = Lane(2, every(1, 30)).tolls();
  EXPECT_NEAR(table.at(RoadId{0U}, 0), 36.88, 0.01);
  EXPECT_LT(table.at(RoadId{0U}, 1), 1);
  EXPECT_GT(table.at(RoadId{0U}, 1), 0);
  EXPECT_EQ(table.at(RoadId{0U}, 30), 0) << "nobody comes any more";
}

// Oracle: one more vehicle, and all others served again. The toll lets those of later count less.
TEST(TollTableTest, AQueuesTollIsTheDelayOfTheOthers) {
  std::mt19937 random(1);
  for (int round = 0; round < 50; ++round) {
    std::vector<float> arrivals(6, 0.0F);  // a queue from the beginning, that does not end before the last
    for (int i = 0; i < 54; ++i) arrivals.push_back(std::uniform_real_distribution<float>(0, 120)(random));
    std::sort(arrivals.begin(), arrivals.end());
    const Lane lane(4, arrivals);
    const TollTable table = lane.tolls();
    for (std::size_t b = 0; b < 6; ++b) {
      const auto extra = static_cast<float>(Lane::middle(b));
      std::vector<float> more = arrivals;
      more.insert(std::upper_bound(more.begin(), more.end(), extra), extra);
      const double others = Lane(4, more).waiting() - lane.waiting() - lane.wait_at(extra);
      EXPECT_GE(table.at(RoadId{0U}, b), 0.7 * others - 4) << round << ", " << b;
      if (others > 80) {
        EXPECT_LE(table.at(RoadId{0U}, b), std::max(others, 42.0) + 4) << round << ", " << b;
      }
    }
  }
}

// Half of d(x) as in the literature, by its difference quotient. Vehicles come evenly, so that nobody waits.
TEST(TollTableTest, AFlowBelowCapacityCostsWhatItsOverflowDelayGrowsBy) {
  const auto delay = [](double x) { return 75 * (x - 1 + std::sqrt((x - 1) * (x - 1) + 4 * x * 2 / 300)); };
  float before = 0;
  for (const double seconds : {10.0, 5.0, 2.5}) {
    const double x = 2 / seconds;
    const float toll = Lane(2, every(seconds, 1200)).tolls().at(RoadId{0U}, 30);
    EXPECT_NEAR(toll, 0.5 * x * (delay(x + 1e-4) - delay(x - 1e-4)) / 2e-4, 0.05) << x;
    EXPECT_GT(toll, before);
    before = toll;
  }
  EXPECT_GT(before, 5);
}

// Two in the first 20 s and one 300 s later, each of them three headways of 2 s; the later one counts 1/e.
TEST(TollTableTest, WhoIsHeldUpBehindThoseOfAFullRoadCounts) {
  TollTable table(2, bin, bins);
  std::vector<float> delayed(bins, 0.0F);
  delayed[0] = 2;
  delayed[15] = 1;
  table.add_spillback(RoadId{1U}, 2, delayed);
  EXPECT_NEAR(table.at(RoadId{1U}, 0), 6 * (2 + std::exp(-1)), 0.01);
  EXPECT_NEAR(table.at(RoadId{1U}, 15), 6, 0.01);
  EXPECT_EQ(table.at(RoadId{1U}, 16), 0);
  EXPECT_EQ(table.at(RoadId{0U}, 0), 0);
  table.clear(RoadId{1U});
  EXPECT_EQ(table.at(RoadId{1U}, 0), 0);
}

}  // namespace
}  // namespace thalweg::testing
