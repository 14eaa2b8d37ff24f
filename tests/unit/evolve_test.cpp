// SPDX-License-Identifier: Apache-2.0
#include "search/evolve.hpp"

#include <gtest/gtest.h>

#include "search/hybrid.hpp"
#include "support/instance.hpp"
#include "support/random_graph.hpp"

namespace thalweg {
namespace {

using testing::arcs;
using testing::Instance;
using testing::make_instance;
using Labels = IdVector<VertexId, Millis>;

struct Evolved {
  Tree tree;
  Evolution evolution;
};

template <Direction direction>
Evolved evolved(const Instance& instance, VertexId source, EvolutionLimit limit = {},
                std::span<const VertexId> targets = {}) {
  Regions regions;
  Evolved out;
  EvolveScratch scratch;
  partition<direction>(instance.graph, std::span(&source, 1), regions);
  hybrid<direction>(instance.graph, regions, instance, out.tree);
  out.evolution = evolve<direction>(instance.graph, regions, instance, out.tree, scratch, limit, targets);
  return out;
}

constexpr VertexId origin{0U};

//   0 --9--> 1 --1--> 3 --1--> 4       2 is found after 1 and makes it cheaper: 3 and 4, which come later,
//   0 --1--> 2 --1--> 1                see that in the same round; round 2 has only 1 to look at
const Instance& detour() {
  static const Instance instance = make_instance(5, {{0, 1, 9}, {0, 2, 1}, {2, 1, 1}, {1, 3, 1}, {3, 4, 1}});
  return instance;
}

TEST(Evolve, RemovesTheAntiEvent) {
  const auto [tree, evolution] = evolved<Direction::forward>(detour(), origin);
  EXPECT_EQ(tree.label, (Labels{0, 2, 1, 3, 4}));
  EXPECT_EQ(path<Direction::forward>(detour().graph, tree, VertexId{4U}), arcs({1, 2, 3, 4}));
  EXPECT_TRUE(evolution.settled);
  EXPECT_EQ(evolution.changes, 3U);
  EXPECT_GT(evolution.rounds, 1U);
}

TEST(Evolve, BackwardToo) {
  const auto [tree, evolution] = evolved<Direction::backward>(detour(), VertexId{4U});
  EXPECT_EQ(tree.label, (Labels{4, 2, 3, 1, 0}));
  EXPECT_EQ(path<Direction::backward>(detour().graph, tree, origin), arcs({1, 2, 3, 4}));
}

TEST(Evolve, SaysWhenTheRoundsWereNotEnough) {
  const auto [tree, evolution] = evolved<Direction::forward>(detour(), origin, {.max_rounds = 1});
  EXPECT_FALSE(evolution.settled);
  EXPECT_EQ(evolution.rounds, 1U);
  EXPECT_GT(tree.label[VertexId{4U}], 4);
  const Evolved enough = evolved<Direction::forward>(detour(), origin);
  EXPECT_TRUE(evolved<Direction::forward>(detour(), origin, {.max_rounds = enough.evolution.rounds})
                  .evolution.settled);
}

//   0 --1--> 1 --1--> 2: nothing to repair, which takes one round to see
TEST(Evolve, OneRoundWhereHybridIsRight) {
  const auto evolution = evolved<Direction::forward>(make_instance(3, {{0, 1}, {1, 2}}), origin).evolution;
  EXPECT_EQ(evolution.rounds, 1U);
  EXPECT_EQ(evolution.changes, 0U);
  EXPECT_TRUE(evolution.settled);
}

//   0 --0--> 1 --0--> 2 --0--> 1       a cycle that costs nothing, and a loop
TEST(Evolve, AFreeCycleDoesNotTurnIntoParents) {
  const auto instance = make_instance(3, {{0, 1, 0}, {1, 2, 0}, {2, 1, 0}, {1, 1, 0}, {1, 0, 0}});
  const auto [tree, evolution] = evolved<Direction::forward>(instance, origin);
  EXPECT_EQ(evolution.changes, 0U);
  EXPECT_EQ(path<Direction::forward>(instance.graph, tree, VertexId{2U}), arcs({0, 1}));
  EXPECT_FALSE(tree.parent[origin].valid());
}

//   0 --closed--> 2        the only fewest-arc path is closed; hybrid leaves 2 out, evolution finds the other
//   0 --1--> 1 --1--> 2
TEST(Evolve, FindsTheWayRoundAClosedArc) {
  const auto instance = make_instance(4, {{0, 2, infinity}, {0, 1, 1}, {1, 2, 1}, {2, 3, infinity}});
  const auto [tree, evolution] = evolved<Direction::forward>(instance, origin);
  EXPECT_EQ(tree.label, (Labels{0, 1, 2, infinity}));
  EXPECT_FALSE(tree.parent[VertexId{3U}].valid());
}

//   0 --2--> 1               1 is the target and right from the start: what lies at 2 or beyond is left
//   alone, 0 --2--> 2 --0--> 1      also 2, which is as dear as the target, and 4, which is wrong
//            2 --1--> 3 --1--> 4,  2 --9--> 4
TEST(Evolve, LeavesAloneWhatCannotImproveATarget) {
  const auto instance = make_instance(5, {{0, 1, 2}, {0, 2, 2}, {2, 1, 0}, {2, 3, 1}, {3, 4, 1}, {2, 4, 9}});
  const VertexId target{1U};
  const Evolved all = evolved<Direction::forward>(instance, origin);
  const Evolved cut = evolved<Direction::forward>(instance, origin, {}, std::span(&target, 1));
  EXPECT_EQ(all.tree.label[VertexId{4U}], 4);
  EXPECT_EQ(cut.tree.label[VertexId{4U}], 11);
  EXPECT_EQ(cut.evolution.changes, 0U);
  EXPECT_EQ(cut.tree.label[target], 2);
}

//   0 --5--> 1               the target's improvement arrives over free arcs at exactly the label of 3
//   0 --1--> 2 --3--> 3 --0--> 4 --0--> 1
TEST(Evolve, FreeArcsToATargetAreFollowed) {
  const auto instance = make_instance(5, {{0, 1, 5}, {0, 2, 1}, {2, 3, 3}, {3, 4, 0}, {4, 1, 0}});
  const VertexId targets[] = {VertexId{1U}, VertexId{2U}};
  const auto [tree, evolution] = evolved<Direction::forward>(instance, origin, {}, targets);
  EXPECT_EQ(tree.label[targets[0]], 4);
  EXPECT_EQ(path<Direction::forward>(instance.graph, tree, targets[0]), arcs({1, 2, 3, 4}));
}

// Only the origin has a region, and an unsettled run before left 1 in the scratch's queue.
TEST(Evolve, GoesBeyondTheRegionsWithAUsedScratch) {
  Regions regions;
  Tree tree;
  EvolveScratch scratch;
  const auto run = [&](std::span<const VertexId> until, EvolutionLimit limit) {
    partition<Direction::forward>(detour().graph, std::span(&origin, 1), regions, until);
    hybrid<Direction::forward>(detour().graph, regions, detour(), tree);
    return evolve<Direction::forward>(detour().graph, regions, detour(), tree, scratch, limit).settled;
  };
  EXPECT_FALSE(run({}, {.max_rounds = 1}));
  EXPECT_TRUE(run(std::span(&origin, 1), {}));
  EXPECT_EQ(tree.label, (Labels{0, 2, 1, 3, 4}));
}

TEST(Evolve, OfNothingAndOfOneVertex) {
  Tree tree;
  EvolveScratch scratch;
  const Evolution none = evolve<Direction::forward>(Digraph{}, Regions{}, Instance{}, tree, scratch);
  EXPECT_TRUE(none.settled);
  EXPECT_EQ(none.rounds, 0U);
  EXPECT_EQ(evolved<Direction::forward>(make_instance(1, {{0, 0, 0}}), origin).tree.label, (Labels{0}));
}

TEST(Evolve, CheaperThanTheDearestTargetIsExact) {
  std::size_t cut_vertices = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Instance instance = testing::random_grid(7, seed, 20);
    testing::Dice dice(seed);
    const VertexId targets[] = {VertexId{dice.roll(49)}, VertexId{dice.roll(49)}};
    const Tree tree = evolved<Direction::backward>(instance, origin, {}, targets).tree;
    const auto least = testing::least_costs(instance, origin, Direction::backward);
    const Millis dearest = std::max(least[targets[0].value], least[targets[1].value]);
    for (std::size_t i = 0; i < least.size(); ++i) {
      ASSERT_GE(tree.label[VertexId{i}], least[i]);
      if (least[i] < dearest) {
        ASSERT_EQ(tree.label[VertexId{i}], least[i]) << "seed " << seed << " vertex " << i;
      }
      cut_vertices += tree.label[VertexId{i}] > least[i] ? 1U : 0U;
    }
  }
  EXPECT_GT(cut_vertices, 100U) << "nothing was cut: the test shows nothing";
}

// Frontiers this large are put in order first: with costs of every size, all free, and some closed.
TEST(Evolve, IsExactOnLargeFrontiers) {
  constexpr std::size_t side = 40;
  static_assert(side * side >= detail::worth_ordering);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Instance instance = testing::random_grid(side, seed, 1);
    instance.costs = testing::random_costs(instance.costs.size(), seed);
    if (seed % 4 == 1) {
      for (Millis& cost : instance.costs) cost *= 1'000'000'000;
    }
    testing::Dice dice(seed);
    const VertexId source{dice.roll(side * side)};
    const VertexId targets[] = {VertexId{dice.roll(side * side)}, VertexId{dice.roll(side * side)}};
    const auto least = testing::least_costs(instance, source, Direction::backward);
    const Evolved all = evolved<Direction::backward>(instance, source);
    const Evolved cut = evolved<Direction::backward>(instance, source, {}, targets);
    ASSERT_TRUE(all.evolution.settled && cut.evolution.settled);
    for (std::size_t i = 0; i < least.size(); ++i)
      ASSERT_EQ(all.tree.label[VertexId{i}], least[i]) << "seed " << seed;
    for (const VertexId target : targets)
      ASSERT_EQ(cut.tree.label[target], least[target.value]) << "seed " << seed;
  }
}

// However few rounds: every label has a path that costs no more.
TEST(Evolve, UnsettledLabelsAreUpperBoundsWithPaths) {
  std::size_t unsettled = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Instance instance = testing::random_grid(8, seed, 50);
    const auto [tree, evolution] = evolved<Direction::forward>(instance, origin, {.max_rounds = 1});
    unsettled += evolution.settled ? 0U : 1U;
    for (std::size_t i = 0; i < 64; ++i) {
      const auto found = path<Direction::forward>(instance.graph, tree, VertexId{i});
      ASSERT_TRUE(found.has_value());
      Millis cost = 0;
      for (const ArcId arc : *found) cost += instance(arc);
      ASSERT_LE(cost, tree.label[VertexId{i}]);
    }
  }
  EXPECT_GT(unsettled, 50U);
}

}  // namespace
}  // namespace thalweg
