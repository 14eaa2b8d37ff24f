// SPDX-License-Identifier: Apache-2.0
#include "search/evolve_rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "search/dijkstra.hpp"
#include "search/instance.hpp"
#include "support/instance.hpp"
#include "support/random_graph.hpp"

namespace thalweg {
namespace {

using testing::Instance;
using testing::make_instance;
using Labels = IdVector<VertexId, Millis>;
using Changes = std::vector<std::uint64_t>;

constexpr VertexId origin{0U};

struct Evolved {
  Tree tree;
  RoundEvolution evolution;
};

Evolved evolved(const Instance& instance, const RoundOptions& options = {}) {
  Evolved out;
  Regions regions;
  partition<Direction::forward>(instance.graph, {&origin, 1}, regions);
  hybrid<Direction::forward>(instance.graph, regions, instance, out.tree, options.criterion);
  out.evolution = evolve_in_rounds<Direction::forward>(instance.graph, instance, out.tree, options);
  return out;
}

/// 0 leads everywhere, dearly but for 1; the cheap way is from each vertex to the next. All are in region 2,
/// so hybrid takes every dear arc, and a label is right only when the one before it is.
Instance chain(std::size_t count) {
  std::vector<ArcEnds> ends;
  std::vector<Millis> costs;
  for (std::size_t v = 1; v < count; ++v) {
    ends.push_back({.tail = origin, .head = VertexId{v}});
    costs.push_back(v == 1 ? 1 : 1'000'000);
    if (v + 1 < count) {
      ends.push_back({.tail = VertexId{v}, .head = VertexId{v + 1}});
      costs.push_back(1);
    }
  }
  return {.graph = Digraph(count, ends), .costs = std::move(costs)};
}

//   0 --9--> 1 --1--> 3        0 --1--> 2 --1--> 1: the anti event, removed at 1 and then at 3
TEST(EvolveInRounds, CountsWhatEachRoundChanges) {
  const auto instance = make_instance(4, {{0, 1, 9}, {0, 2, 1}, {2, 1, 1}, {1, 3, 1}});
  const Evolved in_place = evolved(instance);
  EXPECT_EQ(in_place.tree.label, (Labels{0, 2, 1, 3}));
  EXPECT_EQ(in_place.evolution.changes, (Changes{2, 0}));
  EXPECT_TRUE(in_place.evolution.settled);
  const Evolved former = evolved(instance, {.update = RoundUpdate::from_former_round});
  EXPECT_EQ(former.tree.label, in_place.tree.label);
  EXPECT_EQ(former.evolution.changes, (Changes{1, 1, 0})) << "3 sees 1 a round late";
}

TEST(EvolveInRounds, TheOrderDecidesHowFarNewsGoesInARound) {
  constexpr std::size_t count = 50;
  std::vector<VertexId> descending;
  for (std::size_t v = count; v > 0; --v) descending.emplace_back(v - 1);
  EXPECT_EQ(evolved(chain(count)).evolution.changes, (Changes{count - 2, 0}));
  const Evolved against = evolved(chain(count), {.order = descending});
  EXPECT_EQ(against.evolution.rounds(), count - 1);
  EXPECT_EQ(against.evolution.total(), count - 2);
}

// docs/paper.md: at most V - 1 rounds, the last of which sees that nothing changes; the chain needs them all.
TEST(EvolveInRounds, TheChainReachesTheBoundAndNoOtherGraphPassesIt) {
  for (const std::size_t count : {3U, 4U, 10U, 200U}) {
    const Evolved worst = evolved(chain(count), {.update = RoundUpdate::from_former_round});
    EXPECT_EQ(worst.evolution.rounds(), count - 1);
    EXPECT_TRUE(worst.evolution.settled);
    EXPECT_EQ(worst.tree.label[VertexId{count - 1}], static_cast<Millis>(count - 1));
    const Evolved cut = evolved(chain(count), {.update = RoundUpdate::from_former_round,
                                               .limit = {static_cast<std::uint32_t>(count - 2)}});
    EXPECT_FALSE(cut.evolution.settled) << "one round less cannot tell";
  }
}

// The figure: equal to Dijkstra to the last unit on 10,000 seeded random graphs of all three types,
// with vertices of degree zero and vertices out of reach; and so is the fast form, whose labels are the same.
TEST(EvolveInRounds, EqualsDijkstraOnTenThousandRandomGraphs) {
  DijkstraScratch dijkstra_scratch;
  EvolveScratch evolve_scratch;
  Regions regions;
  Tree least;
  Tree fast;
  std::size_t graphs = 0;
  std::size_t repaired = 0;
  std::size_t isolated = 0;
  std::size_t unreached = 0;
  for (std::uint64_t seed = 0; graphs < 10'000; ++seed) {
    for (const InstanceType type : {InstanceType::mixed, InstanceType::simple, InstanceType::directed}) {
      const Instance instance = testing::random_instance(type, seed);
      const std::size_t count = instance.graph.vertex_count();
      ++graphs;
      dijkstra<Direction::forward>(instance.graph, {&origin, 1}, instance, least, dijkstra_scratch);
      partition<Direction::forward>(instance.graph, {&origin, 1}, regions);
      hybrid<Direction::forward>(instance.graph, regions, instance, fast);
      repaired += fast.label != least.label ? 1U : 0U;
      evolve<Direction::forward>(instance.graph, regions, instance, fast, evolve_scratch);
      ASSERT_EQ(fast.label, least.label) << "seed " << seed;
      for (const RoundUpdate update : {RoundUpdate::in_place, RoundUpdate::from_former_round}) {
        const Evolved found = evolved(instance, {.update = update});
        ASSERT_EQ(found.tree.label, least.label) << "seed " << seed;
        ASSERT_TRUE(found.evolution.settled);
        ASSERT_LE(found.evolution.rounds(), std::max<std::size_t>(1, count - 1)) << "seed " << seed;
      }
      for (std::size_t v = 0; v < count; ++v) {
        unreached += least.label[VertexId{v}] >= infinity ? 1U : 0U;
        isolated +=
            instance.graph.in(VertexId{v}).empty() && instance.graph.out(VertexId{v}).empty() ? 1U : 0U;
      }
    }
  }
  EXPECT_GE(graphs, 10'000U);
  EXPECT_GT(repaired, 1'000U) << "hybrid was right nearly always: the test shows little";
  EXPECT_GT(isolated, 1'000U);
  EXPECT_GT(unreached, 1'000U);
}

//   0 --1--> 1 --1--> 2 --1--> 1: whoever wants the most goes round and round
TEST(EvolveInRounds, MaximumNeverSettlesOnACycle) {
  const auto instance = make_instance(3, {{0, 1}, {1, 2}, {2, 1}});
  const Evolved bounded = evolved(instance, {.criterion = Criterion::maximum});
  EXPECT_FALSE(bounded.evolution.settled);
  EXPECT_EQ(bounded.evolution.rounds(), 3U) << "the bound by default is the number of vertices";
  const Evolved longer = evolved(instance, {.criterion = Criterion::maximum, .limit = {1'000}});
  EXPECT_FALSE(longer.evolution.settled);
  EXPECT_GT(longer.tree.label[VertexId{2U}], 1'000);
  EXPECT_TRUE(std::all_of(longer.evolution.changes.begin(), longer.evolution.changes.end(),
                          [](std::uint64_t changes) { return changes > 0; }));
}

//   0 --1--> 1 --1--> 2      and 0 --1--> 2: without a cycle the greatest value is found, and it settles
TEST(EvolveInRounds, MaximumSettlesWithoutCycles) {
  const auto instance = make_instance(4, {{0, 1}, {1, 2}, {0, 2}, {2, 3}});
  const Evolved found = evolved(instance, {.criterion = Criterion::maximum});
  EXPECT_TRUE(found.evolution.settled);
  EXPECT_EQ(found.tree.label, (Labels{0, 1, 2, 3}));
}

TEST(EvolveInRounds, OfNothingAndOfOneVertex) {
  Tree tree;
  EXPECT_TRUE(evolve_in_rounds<Direction::forward>(Digraph{}, Instance{}, tree).settled);
  const Evolved one = evolved(make_instance(1, {{0, 0, 0}}));
  EXPECT_TRUE(one.evolution.settled);
  EXPECT_EQ(one.evolution.changes, Changes{0});
}

}  // namespace
}  // namespace thalweg
