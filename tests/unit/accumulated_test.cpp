// SPDX-License-Identifier: Apache-2.0
#include "search/accumulated.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "graph/grid.hpp"
#include "support/instance.hpp"
#include "support/random_graph.hpp"

namespace thalweg {
namespace {

using testing::arcs;
using testing::make_instance;
using Weights = std::vector<std::int64_t>;

constexpr VertexId origin{0U};

static_assert(IndexedWeight<WeightTable> && IndexedWeight<StepWeight> && IndexedWeight<LinearWeight>);

Regions regions_of(const Digraph& graph) {
  Regions regions;
  partition<Direction::forward>(graph, {&origin, 1}, regions);
  return regions;
}

TEST(IndexedWeight, TableStepAndLinear) {
  const WeightTable table{.row_length = 2, .weights = {1, 2, 3, 4}, .beyond = 9};
  EXPECT_EQ(table(VertexId{1U}, 0), 3);
  EXPECT_EQ(table(VertexId{1U}, 1), 4);
  EXPECT_EQ(table(VertexId{0U}, 2), 9) << "past the end of the row, not the next row";
  const StepWeight step{.from = {0, 10}, .weights = {5, 7}};
  EXPECT_EQ(step(origin, 0), 5);
  EXPECT_EQ(step(origin, 9), 5);
  EXPECT_EQ(step(origin, 10), 7);
  EXPECT_EQ(LinearWeight{.factor = 3}(origin, 4), 12);
}

//   0 --> 1 --> 3       index 1 over vertex 1, 2 over vertex 2. At 3 (before 4) the lighter label is the one
//   '---> 2 --> 3       with index 2, for which vertex 4 is dear: theorem 2 fails where weights depend on
//         3 --> 4       what was accumulated.
struct Trap {
  testing::Instance instance = make_instance(5, {{0, 1}, {0, 2}, {1, 3}, {2, 3}, {3, 4}});
  WeightTable weight{.row_length = 4,
                     .weights = {0, 0, 0, 0,    // into 0
                                 9, 2, 9, 9,    // into 1, index 1
                                 9, 9, 1, 9,    // into 2, index 2
                                 9, 5, 5, 9,    // into 3
                                 9, 1, 8, 9}};  // into 4: cheap with index 1, dear with index 2
  static std::int64_t index(ArcId arc) { return arc == ArcId{0U} ? 1 : arc == ArcId{1U} ? 2 : 0; }
};

TEST(HybridAccumulated, OneLabelAVertexIsNotExact) {
  const Trap trap;
  const Regions regions = regions_of(trap.instance.graph);
  AccumulatedTree tree;
  hybrid_accumulated(trap.instance.graph, regions, Trap::index, trap.weight, tree);
  EXPECT_EQ(tree.label[VertexId{3U}], (Accumulated{.index = 2, .weight = 6}));
  EXPECT_EQ(tree.label[VertexId{4U}], (Accumulated{.index = 2, .weight = 14}));
  EXPECT_EQ(distinct_weights(trap.instance.graph, regions, VertexId{4U}, Trap::index, trap.weight),
            (Weights{8, 14}));
  EXPECT_EQ(accumulated_on(trap.instance.graph, arcs({0, 2, 4}), Trap::index, trap.weight),
            (Accumulated{.index = 1, .weight = 8}));
}

// Of all fewest-arc paths one by one, by definition; and hybrid's label is that of a path among them.
TEST(DistinctWeights, EqualTheEnumerationOnRandomGrids) {
  std::size_t missed = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    testing::Dice dice(seed);
    const Digraph grid = grid_graph(5);
    const Regions regions = regions_of(grid);
    const VertexId target{24U};
    std::vector<std::int64_t> indices(grid.arc_count());
    for (auto& index : indices) index = static_cast<std::int64_t>(1 + dice.roll(5));
    WeightTable weight{.row_length = 41, .weights = std::vector<std::int64_t>(std::size_t{25} * 41)};
    for (auto& entry : weight.weights) entry = static_cast<std::int64_t>(1 + dice.roll(10));
    const auto index = [&](ArcId arc) { return indices[arc.value]; };
    Weights all;
    for (const auto path : RegionPaths(grid, regions, target)) {
      all.push_back(accumulated_on(grid, path, index, weight).weight);
    }
    ASSERT_EQ(all.size(), 70U);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    ASSERT_EQ(distinct_weights(grid, regions, target, index, weight), all) << "seed " << seed;
    AccumulatedTree tree;
    hybrid_accumulated(grid, regions, index, weight, tree);
    ASSERT_TRUE(std::binary_search(all.begin(), all.end(), tree.label[target].weight)) << "seed " << seed;
    missed += tree.label[target].weight != all.front() ? 1U : 0U;
  }
  EXPECT_GT(missed, 10U);
}

// What does not depend on the index is the static system: theorem 2 holds.
TEST(HybridAccumulated, IsExactWhereTheIndexDoesNotMatter) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    testing::Dice dice(seed);
    const Digraph grid = grid_graph(5);
    const Regions regions = regions_of(grid);
    std::vector<std::int64_t> entering(25);
    for (auto& entry : entering) entry = static_cast<std::int64_t>(1 + dice.roll(10));
    const auto weight = [&](VertexId t, std::int64_t) { return entering[t.value]; };
    const auto index = [](ArcId) { return 1; };
    AccumulatedTree tree;
    hybrid_accumulated(grid, regions, index, weight, tree);
    ASSERT_EQ(tree.label[VertexId{24U}].weight,
              distinct_weights(grid, regions, VertexId{24U}, index, weight).front());
  }
}

TEST(HybridAccumulated, UnreachedAndItself) {
  const auto instance = make_instance(3, {{0, 1}});
  const Regions regions = regions_of(instance.graph);
  AccumulatedTree tree;
  const auto index = [](ArcId) { return 1; };
  hybrid_accumulated(instance.graph, regions, index, LinearWeight{}, tree, {.index = 3, .weight = 7});
  EXPECT_EQ(tree.label[origin], (Accumulated{.index = 3, .weight = 7}));
  EXPECT_EQ(tree.label[VertexId{1U}], (Accumulated{.index = 4, .weight = 11}));
  EXPECT_EQ(tree.label[VertexId{2U}].weight, AccumulatedTree::unreached);
  EXPECT_TRUE(distinct_weights(instance.graph, regions, VertexId{2U}, index, LinearWeight{}).empty());
}

}  // namespace
}  // namespace thalweg
