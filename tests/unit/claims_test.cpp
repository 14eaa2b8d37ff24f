// SPDX-License-Identifier: Apache-2.0
// Counterexamples of docs/paper.md that belong to no single algorithm.
#include <gtest/gtest.h>

#include "search/evolve_rounds.hpp"
#include "search/hybrid.hpp"
#include "search/region_paths.hpp"
#include "support/instance.hpp"
#include "support/random_graph.hpp"

namespace thalweg {
namespace {

using testing::Instance;
using testing::make_instance;

constexpr VertexId origin{0U};

Tree hybrid_of(const Instance& instance, Regions& regions) {
  Tree tree;
  partition<Direction::forward>(instance.graph, {&origin, 1}, regions);
  hybrid<Direction::forward>(instance.graph, regions, instance, tree);
  return tree;
}

//   0 <-2-> 1 <-1-> 2 <-2-> 0
TEST(Claims, HybridsTreeIsNoMinimumSpanningTree) {
  const auto instance = make_instance(3, {{0, 1, 2}, {1, 0, 2}, {1, 2, 1}, {2, 1, 1}, {0, 2, 2}, {2, 0, 2}});
  Regions regions;
  const Tree tree = hybrid_of(instance, regions);
  Millis sum = 0;
  for (const ArcId parent : tree.parent) sum += parent.valid() ? instance(parent) : 0;
  EXPECT_EQ(sum, 4);
  EXPECT_LT(instance(ArcId{0U}) + instance(ArcId{2U}), sum) << "0 - 1 - 2 spans the triangle for less";
}

//   0 --1--> 1 --2--> 2: unequal weights, and the fewest-arc path is the optimal one
TEST(Claims, InferenceNeedsNoEqualWeights) {
  const auto instance = make_instance(3, {{0, 1, 1}, {1, 2, 2}});
  Regions regions;
  const Tree tree = hybrid_of(instance, regions);
  EXPECT_EQ(count_region_paths(instance.graph, regions, VertexId{2U}), 1);
  const auto least = testing::least_costs(instance, origin, Direction::forward);
  EXPECT_EQ(tree.label[VertexId{2U}], least[2]);
}

// The worst case of the rounds, with the arcs out of 0 so that region 2 is in descending order.
TEST(Claims, TheRegionOrderIsNoBetterInTheWorstCase) {
  constexpr std::size_t count = 40;
  std::vector<ArcEnds> ends;
  std::vector<Millis> costs;
  for (std::size_t v = count - 1; v > 0; --v) {
    ends.push_back({.tail = origin, .head = VertexId{v}});
    costs.push_back(v == 1 ? 1 : 1'000);
  }
  for (std::size_t v = 1; v + 1 < count; ++v) {
    ends.push_back({.tail = VertexId{v}, .head = VertexId{v + 1}});
    costs.push_back(1);
  }
  const Instance instance{.graph = Digraph(count, ends), .costs = costs};
  Regions regions;
  Tree tree = hybrid_of(instance, regions);
  const RoundEvolution evolution =
      evolve_in_rounds<Direction::forward>(instance.graph, instance, tree, {.order = regions.order});
  EXPECT_EQ(evolution.rounds(), count - 1);
  EXPECT_EQ(tree.label[VertexId{count - 1}], static_cast<Millis>(count - 1));
}

}  // namespace
}  // namespace thalweg
