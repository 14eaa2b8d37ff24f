// SPDX-License-Identifier: Apache-2.0
#include "search/region_paths.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <ranges>

#include "graph/grid.hpp"
#include "search/simple_paths.hpp"
#include "support/instance.hpp"
#include "support/random_graph.hpp"

namespace thalweg {
namespace {

using testing::arcs;
using testing::make_instance;
using Paths = std::vector<std::vector<ArcId>>;

static_assert(std::ranges::input_range<RegionPaths>);
static_assert(std::ranges::input_range<SimplePaths>);

Regions regions_from(const Digraph& graph, VertexId source) {
  Regions regions;
  partition<Direction::forward>(graph, {&source, 1}, regions);
  return regions;
}

Paths collected(auto&& range) {
  Paths out;
  for (const std::span<const ArcId> path : range) out.emplace_back(path.begin(), path.end());
  return out;
}

constexpr VertexId origin{0U};

//   0 --> 1 --> 3      and 0 --> 3's rival 0 --> 2 --> 3; the long way 0 --> 1 --> 2 --> 3 is no fewest-arc
//   '---> 2 --> 3      path; two arcs join 2 and 3
TEST(RegionPaths, YieldsTheFewestArcPathsInDrivingOrder) {
  const auto instance = make_instance(5, {{0, 1}, {1, 3}, {0, 2}, {2, 3}, {2, 3}, {1, 2}, {3, 0}});
  const Regions regions = regions_from(instance.graph, origin);
  const Paths expected{arcs({0, 1}), arcs({2, 3}), arcs({2, 4})};
  EXPECT_EQ(collected(RegionPaths(instance.graph, regions, VertexId{3U})), expected);
  EXPECT_EQ(count_region_paths(instance.graph, regions, VertexId{3U}), 3);
  EXPECT_EQ(collected(RegionPaths(instance.graph, regions, origin)), Paths{{}});
  EXPECT_EQ(count_region_paths(instance.graph, regions, origin), 1);
  EXPECT_EQ(collected(RegionPaths(instance.graph, regions, VertexId{4U})), Paths{});
  EXPECT_EQ(count_region_paths(instance.graph, regions, VertexId{4U}), 0);
}

// The paper's table: 70 paths; its 252 loops are C(2k, k), of which a walk enters one less.
TEST(RegionPaths, OnThePapersGrid) {
  const Digraph grid = grid_graph(5);
  const Regions regions = regions_from(grid, origin);
  RegionPaths paths(grid, regions, VertexId{24U});
  EXPECT_EQ(std::ranges::distance(paths.begin(), paths.end()), 70);
  EXPECT_EQ(paths.visits(), 251U);
  EXPECT_FALSE(paths.advance());
}

TEST(RegionPaths, IsLazy) {
  const Digraph grid = grid_graph(100);  // C(198, 99) paths: nobody could wait for them
  const Regions regions = regions_from(grid, origin);
  RegionPaths paths(grid, regions, VertexId{9'999U});
  ASSERT_TRUE(paths.advance());
  EXPECT_EQ(paths.path().size(), 198U);
  EXPECT_EQ(grid.ends(paths.path().front()).tail, origin);
  EXPECT_EQ(grid.ends(paths.path().back()).head, VertexId{9'999U});
  EXPECT_EQ(paths.visits(), 199U);
}

BigCount binomial(unsigned n, unsigned k) {
  BigCount out = 1;
  for (unsigned i = 1; i <= k; ++i) out = out * (n - k + i) / i;
  return out;
}

TEST(CountRegionPaths, IsTheBinomialOnEveryGridUpTo200) {
  for (const unsigned k : {1U, 2U, 3U, 10U, 50U, 200U}) {
    const Digraph grid = grid_graph(k);
    const VertexId corner{grid.vertex_count() - 1};
    EXPECT_EQ(count_region_paths(grid, regions_from(grid, origin), corner), binomial(2 * k - 2, k - 1)) << k;
  }
}

// By their definition: the simple paths that have the fewest arcs. Also the paper's R_EBOGP in R_BOTS.
TEST(RegionPaths, AreTheShortestOfTheSimplePathsOnRandomGraphs) {
  std::size_t several = 0;
  for (const InstanceType type : {InstanceType::mixed, InstanceType::simple, InstanceType::directed}) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      const auto instance = testing::random_instance(type, seed);
      const VertexId target{instance.graph.vertex_count() / 2};
      SimplePaths all(instance.graph, origin, target, {.max_loops = 50'000});
      Paths shortest;
      for (const auto path : all) {
        if (!shortest.empty() && path.size() > shortest.front().size()) continue;
        if (!shortest.empty() && path.size() < shortest.front().size()) shortest.clear();
        shortest.emplace_back(path.begin(), path.end());
      }
      if (all.cut()) continue;
      const Regions regions = regions_from(instance.graph, origin);
      Paths found = collected(RegionPaths(instance.graph, regions, target));
      EXPECT_EQ(count_region_paths(instance.graph, regions, target), found.size());
      std::ranges::sort(found);
      std::ranges::sort(shortest);
      ASSERT_EQ(found, shortest) << "seed " << seed;
      several += found.size() > 1 ? 1U : 0U;
    }
  }
  EXPECT_GT(several, 30U);
}

}  // namespace
}  // namespace thalweg
