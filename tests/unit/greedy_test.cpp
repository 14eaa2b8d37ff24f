// SPDX-License-Identifier: Apache-2.0
#include "search/greedy.hpp"

#include <gtest/gtest.h>

#include "support/instance.hpp"
#include "support/random_graph.hpp"

namespace thalweg {
namespace {

using testing::arcs;
using testing::make_instance;

constexpr VertexId origin{0U};

//   0 --5--> 3                    the greedy one gets by with arcs of 1 and goes round
//   0 --1--> 1 --1--> 2 --1--> 3
TEST(GreedyHybrid, SearchesOnlyTheCheapestArcsThatConnect) {
  const auto instance = make_instance(4, {{0, 3, 5}, {0, 1, 1}, {1, 2, 1}, {2, 3, 1}});
  const GreedyHybrid greedy = greedy_hybrid(instance.graph, origin, VertexId{3U}, instance);
  EXPECT_EQ(greedy.path, arcs({1, 2, 3}));
  EXPECT_EQ(greedy.cost, 3);
  EXPECT_EQ(greedy.arcs_used, 3U);
  EXPECT_EQ(greedy.batches, 1U);
}

// The same, with batches that reach the dear arc before they connect: hybrid then takes the fewest arcs.
TEST(GreedyHybrid, TheBatchDecidesWhatIsSearched) {
  const auto instance = make_instance(4, {{0, 3, 5}, {0, 1, 1}, {1, 2, 1}, {2, 3, 1}});
  const auto with = [&](std::size_t batch) {
    return greedy_hybrid(instance.graph, origin, VertexId{3U}, instance, batch);
  };
  EXPECT_EQ(with(1).batches, 3U);
  EXPECT_EQ(with(1).path, arcs({1, 2, 3}));
  EXPECT_EQ(with(2).arcs_used, 4U);
  EXPECT_EQ(with(2).path, arcs({0}));
  EXPECT_EQ(with(100).batches, 1U);
}

TEST(GreedyHybrid, OutOfReachAndAtOnceThere) {
  const auto instance = make_instance(3, {{0, 1}, {1, 2, infinity}});
  const GreedyHybrid none = greedy_hybrid(instance.graph, origin, VertexId{2U}, instance, 1);
  EXPECT_EQ(none.cost, infinity);
  EXPECT_EQ(none.arcs_used, 1U);
  const GreedyHybrid here = greedy_hybrid(instance.graph, origin, origin, instance);
  EXPECT_EQ(here.cost, 0);
  EXPECT_EQ(here.batches, 0U);
}

// By the definition, one partition a batch; and with every arc in the first batch it is hybrid.
TEST(GreedyHybrid, EqualsThePapersLoopOnRandomGrids) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const auto instance = testing::random_grid(6, seed, 6);
    const VertexId target{35U};
    const std::size_t batch = 1 + seed % 30;
    std::vector<ArcId> sorted;
    for (std::size_t i = 0; i < instance.costs.size(); ++i) sorted.emplace_back(i);
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](ArcId a, ArcId b) { return instance(a) < instance(b); });
    Regions regions;
    Tree tree;
    for (std::size_t used = batch;; used += batch) {
      std::vector<ArcEnds> ends;
      std::vector<Millis> added;
      for (std::size_t i = 0; i < std::min(used, sorted.size()); ++i) {
        ends.push_back(instance.graph.ends(sorted[i]));
        added.push_back(instance(sorted[i]));
      }
      const Digraph graph(36, ends);
      partition<Direction::forward>(graph, {&origin, 1}, regions);
      if (regions.number[target] == 0) continue;
      hybrid<Direction::forward>(
          graph, regions, [&](ArcId arc) { return added[arc.value]; }, tree);
      const GreedyHybrid greedy = greedy_hybrid(instance.graph, origin, target, instance, batch);
      ASSERT_EQ(greedy.cost, tree.label[target]) << "seed " << seed;
      ASSERT_EQ(greedy.arcs_used, ends.size()) << "seed " << seed;
      break;
    }
    partition<Direction::forward>(instance.graph, {&origin, 1}, regions);
    hybrid<Direction::forward>(instance.graph, regions, instance, tree);
    const GreedyHybrid all = greedy_hybrid(instance.graph, origin, target, instance, instance.costs.size());
    EXPECT_EQ(all.path, path<Direction::forward>(instance.graph, tree, target));
  }
}

}  // namespace
}  // namespace thalweg
