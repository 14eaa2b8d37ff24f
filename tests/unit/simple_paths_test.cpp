// SPDX-License-Identifier: Apache-2.0
#include "search/simple_paths.hpp"

#include <gtest/gtest.h>

#include <set>

#include "graph/grid.hpp"
#include "support/instance.hpp"
#include "support/random_graph.hpp"

namespace thalweg {
namespace {

using testing::arcs;
using testing::make_instance;
using Paths = std::vector<std::vector<ArcId>>;

constexpr VertexId origin{0U};

VertexId corner(const Digraph& grid) { return VertexId{grid.vertex_count() - 1}; }

//   0 --> 1 --> 2 --> 0     and 0 --> 2 twice, a loop at 1; 3 is a dead end
TEST(SimplePaths, AreAllOfThemOnceInTheOrderOfTheArcs) {
  const auto instance = make_instance(4, {{0, 1}, {1, 1}, {1, 2}, {2, 0}, {0, 2}, {0, 2}, {1, 3}});
  Paths found;
  SimplePaths paths(instance.graph, origin, VertexId{2U});
  for (const auto path : paths) found.emplace_back(path.begin(), path.end());
  EXPECT_EQ(found, (Paths{arcs({0, 2}), arcs({4}), arcs({5})}));
  EXPECT_EQ(paths.paths(), 3U);
  EXPECT_EQ(paths.loops(), 2U) << "to 1, and from there to 3";
  EXPECT_FALSE(paths.cut());
  EXPECT_FALSE(paths.advance());
}

TEST(SimplePaths, FromAVertexToItselfAndToNowhere) {
  const auto instance = make_instance(3, {{0, 1}, {1, 0}});
  SimplePaths itself(instance.graph, origin, origin);
  EXPECT_TRUE(itself.advance());
  EXPECT_TRUE(itself.path().empty());
  EXPECT_FALSE(itself.advance());
  SimplePaths nowhere(instance.graph, origin, VertexId{2U});
  EXPECT_FALSE(nowhere.advance());
  EXPECT_EQ(count_simple_paths(instance.graph, origin, origin), 1);
  EXPECT_EQ(count_simple_paths(instance.graph, origin, VertexId{2U}), 0);
}

// The paper's table, to the last loop.
TEST(SimplePaths, OnThePapersGrid) {
  const Digraph grid = grid_graph(5);
  SimplePaths paths(grid, origin, corner(grid));
  while (paths.advance()) ASSERT_LE(paths.path().size(), 24U);
  EXPECT_EQ(paths.paths(), 8'512U);
  EXPECT_EQ(paths.loops(), 81'598U);
}

TEST(SimplePaths, EndAtTheirLimitsAndSayHowFarTheyCame) {
  const Digraph grid = grid_graph(20);
  SimplePaths few(grid, origin, corner(grid), {.max_paths = 1'000});
  while (few.advance()) ASSERT_FALSE(few.cut());
  EXPECT_TRUE(few.cut());
  EXPECT_EQ(few.paths(), 1'000U);
  EXPECT_FALSE(few.advance());
  SimplePaths steps(grid, origin, corner(grid), {.max_loops = 5'000});
  while (steps.advance()) ASSERT_LE(steps.loops(), 5'000U);
  EXPECT_TRUE(steps.cut());
  EXPECT_EQ(steps.loops(), 5'000U);
  const Digraph square = grid_graph(2);
  SimplePaths exactly(square, origin, VertexId{3U}, {.max_paths = 2});
  while (exactly.advance()) ASSERT_FALSE(exactly.cut());
  EXPECT_FALSE(exactly.cut()) << "as many as allowed, and no more to come";
}

// OEIS A007764.
TEST(CountSimplePaths, OnGrids) {
  const auto count = [](std::size_t side) {
    const Digraph grid = grid_graph(side);
    return count_simple_paths(grid, origin, corner(grid)).value();
  };
  EXPECT_EQ(count(2), 2);
  EXPECT_EQ(count(3), 12);
  EXPECT_EQ(count(4), 184);
  EXPECT_EQ(count(5), 8'512);
  EXPECT_EQ(count(6), 1'262'816);
  EXPECT_EQ(count(7), 575'780'564);
}

TEST(CountSimplePaths, CountsTheLoopsToo) {
  const Digraph grid = grid_graph(5);
  EXPECT_EQ(count_simple_path_loops(grid, origin, corner(grid)), 81'598);
}

TEST(CountSimplePaths, GivesUpRatherThanFillTheMemory) {
  const Digraph grid = grid_graph(7);
  EXPECT_FALSE(count_simple_paths(grid, origin, corner(grid), 100).has_value());
  EXPECT_FALSE(count_simple_paths(grid_graph(70), origin, VertexId{4'899U}).has_value());
}

TEST(CountSimplePaths, EqualsEnumerationOnRandomGraphs) {
  std::size_t checked = 0;
  for (const InstanceType type : {InstanceType::mixed, InstanceType::simple, InstanceType::directed}) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      const auto instance = testing::random_instance(type, seed);
      if (instance.graph.vertex_count() > 12) continue;
      const VertexId target{instance.graph.vertex_count() - 1};
      SimplePaths paths(instance.graph, origin, target, {.max_loops = 200'000});
      std::set<std::vector<ArcId>> different;
      for (const auto path : paths) different.insert({path.begin(), path.end()});
      if (paths.cut()) continue;
      EXPECT_EQ(different.size(), paths.paths());
      ASSERT_EQ(count_simple_paths(instance.graph, origin, target), paths.paths()) << "seed " << seed;
      ASSERT_EQ(count_simple_path_loops(instance.graph, origin, target), paths.loops()) << "seed " << seed;
      checked += paths.paths() > 1 ? 1U : 0U;
    }
  }
  EXPECT_GT(checked, 50U);
}

}  // namespace
}  // namespace thalweg
