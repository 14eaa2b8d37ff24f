// SPDX-License-Identifier: Apache-2.0
#include "simulation/kept_positions.hpp"

#include <gtest/gtest.h>

namespace thalweg::testing {
namespace {

using Positions = std::vector<std::size_t>;

// Roads 0, 1 .. as a route; what must be kept of it.
Plan plan(std::vector<RoadId> route, std::vector<RoadId> stops = {}) {
  return {.route = std::move(route), .stops = std::move(stops)};
}
constexpr RoadId a{0U};
constexpr RoadId b{1U};
constexpr RoadId c{2U};
constexpr RoadId d{3U};
constexpr RoadId elsewhere{9U};

TEST(KeptPositions, TheEndAlways) {
  EXPECT_EQ(kept_positions(plan({a, b, c}), {}), Positions{2});
  EXPECT_EQ(kept_positions(plan({a}), {}), Positions{0});
}

TEST(KeptPositions, StopsInTheirOrder) {
  EXPECT_EQ(kept_positions(plan({a, b, c, d}, {b, c}), {}), (Positions{1, 2, 3}));
  EXPECT_EQ(kept_positions(plan({a, b, a, c}, {b, a}), {}), (Positions{1, 2, 3})) << "the second time round";
  EXPECT_TRUE(kept_positions(plan({a, b, c}, {elsewhere}), {}).empty());
  EXPECT_TRUE(kept_positions(plan({a, b, c}, {c, b}), {}).empty()) << "not in this order";
}

TEST(KeptPositions, OfViaThatWhichIsStillAhead) {
  const std::vector<RoadId> via{elsewhere, b, d};
  EXPECT_EQ(kept_positions(plan({a, b, c, d, a}), via), (Positions{1, 3, 4})) << "the first is behind it";
  EXPECT_EQ(kept_positions(plan({c, d, a}), via), (Positions{1, 2}));
  EXPECT_EQ(kept_positions(plan({a, b, c}, {b}), std::vector{b}), (Positions{1, 2})) << "once";
}

}  // namespace
}  // namespace thalweg::testing
