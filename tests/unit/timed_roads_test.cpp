// SPDX-License-Identifier: Apache-2.0
#include "lab/timed_roads.hpp"

#include <gtest/gtest.h>

#include "support/instance.hpp"
#include "support/random_graph.hpp"

namespace thalweg::lab {
namespace {

using testing::make_instance;

//   0 --> 1 --> 3          1 --> 3 takes 50 s before second 10, and 1 s from then on
//   0 --> 2 --> 1          straight to 1: 5 s; over 2: 10 s, and so 11 s to 3 against 55
struct Opening {
  testing::Instance instance = make_instance(4, {{0, 1}, {0, 2}, {2, 1}, {1, 3}});
  TimedCosts costs{{10, 1'000}, {{5, 5, 5, 50}, {5, 5, 5, 1}, {5, 5, 5, 1}}};
  Departure from{.source = VertexId{0U}, .time = 0};
};

TEST(TimedRoads, LeavingLaterMayArriveEarlier) {
  const Opening opening;
  const Digraph& graph = opening.instance.graph;
  const VertexId target{3U};
  TimedTree tree;
  timed_dijkstra(graph, opening.costs, opening.from, tree);
  EXPECT_EQ(tree.arrival[target], 55);
  IdVector<VertexId, Seconds> earliest;
  earliest_arrivals(graph, opening.costs, opening.from, 4, 100, earliest);
  EXPECT_EQ(earliest, (IdVector<VertexId, Seconds>{0, 5, 5, 11}));
  Regions regions;
  partition<Direction::forward>(graph, {&opening.from.source, 1}, regions);
  timed_hybrid(graph, regions, opening.costs, opening.from, tree);
  EXPECT_EQ(tree.arrival[target], 55);
  EXPECT_TRUE(timed_evolution(graph, opening.costs, tree).settled);
  EXPECT_EQ(replay(graph, opening.costs, tree, opening.from, target), 55);
}

TEST(TimedRoads, StopsAtTheHorizon) {
  const Opening opening;
  IdVector<VertexId, Seconds> earliest;
  earliest_arrivals(opening.instance.graph, opening.costs, opening.from, 4, 10, earliest);
  EXPECT_EQ(earliest, (IdVector<VertexId, Seconds>{0, 5, 5, never}));
}

// Costs that never change: all of them find the static optimum, and evolution's labels are its paths'.
TEST(TimedRoads, AreTheStaticSearchesWhereNothingChanges) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const auto instance = testing::random_grid(6, seed, 9);
    const TimedCosts costs({7}, {instance.costs, instance.costs});
    const Departure from{.source = VertexId{seed % 36}, .time = 3};
    const auto least = testing::least_costs(instance, from.source, Direction::forward);
    Regions regions;
    TimedTree tree;
    TimedTree settled;
    IdVector<VertexId, Seconds> earliest;
    partition<Direction::forward>(instance.graph, {&from.source, 1}, regions);
    timed_hybrid(instance.graph, regions, costs, from, tree);
    ASSERT_TRUE(timed_evolution(instance.graph, costs, tree).settled);
    timed_dijkstra(instance.graph, costs, from, settled);
    earliest_arrivals(instance.graph, costs, from, 36, 1'000, earliest);
    for (std::size_t v = 0; v < 36; ++v) {
      ASSERT_EQ(tree.arrival[VertexId{v}], 3 + least[v]);
      ASSERT_EQ(settled.arrival[VertexId{v}], 3 + least[v]);
      ASSERT_EQ(earliest[VertexId{v}], 3 + least[v]);
      ASSERT_EQ(replay(instance.graph, costs, tree, from, VertexId{v}), 3 + least[v]);
    }
  }
}

}  // namespace
}  // namespace thalweg::lab
