// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>

#include "graph/fingerprint.hpp"
#include "graph/grid.hpp"
#include "support/cch_oracle.hpp"

namespace thalweg::testing {
namespace {

using W32 = std::uint32_t;
using W64 = std::uint64_t;
constexpr Millis limit32 = cch_infinity<W32>;

CchTopology topology_of(const Digraph& graph) { return {graph, nested_dissection(graph)}; }

std::vector<VertexId> every_vertex(const Digraph& graph) {
  std::vector<VertexId> all;
  for (std::size_t v = 0; v < graph.vertex_count(); ++v) all.emplace_back(v);
  return all;
}

std::vector<VertexId> sorted(std::vector<VertexId> vertices) {
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

//     0 - 1 - 2 - 3      a ring: in the order of their numbers, 0 joins 1 and 5, then 1 joins 2 and 5 ..
//     |           |
//     +--- 5 - 4 -+
Instance ring() { return make_instance(6, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}}); }

TEST(CchTopology, TheCompletionOfARing) {
  const Instance six = ring();
  const CchTopology topology(six.graph, vertices({0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(topology.edge_count(), 9U);      // six of the ring, and 1-5, 2-5, 3-5
  EXPECT_EQ(topology.triangle_count(), 4U);  // over 0, 1, 2, 3
  for (CchTopology::Rank v = 0; v < 5; ++v) EXPECT_EQ(topology.parent(v), v + 1);
  EXPECT_EQ(topology.parent(5), 5U);
  ASSERT_EQ(topology.lower_edges(5).size(), 5U);
  EXPECT_EQ(topology.lower_edges(5).front().tail, 0U);
  ASSERT_EQ(topology.places(0, 1).size(), 2U);  // 0 -> 1 and 5 -> 0
  for (const auto& place : topology.places(0, 1))
    EXPECT_EQ(place.upward, place.arc == ArcId{0}) << place.arc.value;
}

TEST(CchTopology, PiecesHoldEveryRankOnceAndWhatIsBelowIsInPiecesBelow) {
  const Digraph graph = grid_graph(40);
  const CchTopology topology = topology_of(graph);
  const auto parents = topology.piece_parents();
  ASSERT_GT(parents.size(), 8U);
  constexpr std::size_t unseen = 1'000'000;
  std::vector<std::size_t> piece_of(topology.vertex_count(), unseen);
  for (std::size_t i = 0; i < parents.size(); ++i) {
    EXPECT_GE(parents[i], i);
    ASSERT_FALSE(topology.piece(i).empty());
    EXPECT_TRUE(std::is_sorted(topology.piece(i).begin(), topology.piece(i).end()));
    for (const auto rank : topology.piece(i)) {
      EXPECT_EQ(piece_of[rank], unseen) << rank;
      piece_of[rank] = i;
    }
  }
  for (CchTopology::Rank v = 0; v < topology.vertex_count(); ++v) {
    ASSERT_NE(piece_of[v], unseen) << v;
    for (const auto head : topology.heads(v)) {
      std::size_t above = piece_of[v];
      while (above != piece_of[head] && parents[above] != above) above = parents[above];
      EXPECT_EQ(above, piece_of[head]) << v << " - " << head;
    }
  }
}

TEST(NestedDissection, HoldsEveryVertexOnceAndFillsAGridLittle) {
  const Digraph graph = grid_graph(40);
  const EliminationOrder order = nested_dissection(graph);
  EXPECT_EQ(sorted(order), every_vertex(graph));
  EXPECT_EQ(order, nested_dissection(graph)) << "the same at every call";
  EXPECT_LT(CchTopology(graph, order).edge_count(), 10 * graph.arc_count() / 2);
}

TEST(NestedDissection, OfNothingOfOneRoadAndOfParts) {
  EXPECT_TRUE(nested_dissection(Digraph()).empty());
  const Instance one = make_instance(1, {{0, 0, 7}});
  EXPECT_EQ(topology_of(one.graph).edge_count(), 0U);
  const Instance parts = make_instance(5, {{0, 1}, {2, 3}, {3, 2}});
  EXPECT_EQ(sorted(nested_dissection(parts.graph)), every_vertex(parts.graph));
  EXPECT_EQ(topology_of(Digraph(3, {})).edge_count(), 0U);
}

TEST(Postordered, AddsTheSameEdges) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Instance instance = random_instance(InstanceType::mixed, seed);
    Dice dice(seed);
    EliminationOrder order = every_vertex(instance.graph);
    dice.shuffle(order);
    const EliminationOrder post = postordered(instance.graph, order);
    EXPECT_EQ(sorted(post), every_vertex(instance.graph));
    EXPECT_EQ(CchTopology(instance.graph, post).edge_count(),
              CchTopology(instance.graph, order).edge_count());
    EXPECT_EQ(postordered(instance.graph, post), post);
  }
}

class CchOnRandomGraphs : public ::testing::TestWithParam<InstanceType> {};

// 10,000 in all: every vertex to and from every other.
TEST_P(CchOnRandomGraphs, CostsAreDijkstras) {
  CchOracle<W32> narrow;
  CchOracle<W64> wide;
  for (std::uint64_t seed = 0; seed < 3'334; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    const Instance instance = random_instance(GetParam(), seed);
    const CchTopology topology = topology_of(instance.graph);
    const auto all = every_vertex(instance.graph);
    narrow.check(topology, instance, all, all);
    if (seed % 3 == 0) wide.check(topology, instance, all, all, 2);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(narrow.reached, 100'000U);
  EXPECT_GT(narrow.only, 10'000U);
  EXPECT_GT(narrow.not_only, 10'000U);
}

INSTANTIATE_TEST_SUITE_P(AllTypes, CchOnRandomGraphs,
                         ::testing::Values(InstanceType::mixed, InstanceType::simple,
                                           InstanceType::directed));

TEST(Cch, ThreadsDoNotChangeTheMetric) {
  const Instance instance = random_grid(40, 7, 10'000);
  const CchTopology topology = topology_of(instance.graph);
  CchMetric<W32> alone;
  alone.customise(topology, instance.costs, 1);
  for (const std::size_t threads : {2U, 4U}) {
    CchMetric<W32> together;
    together.customise(topology, instance.costs, threads);
    EXPECT_EQ(together.up, alone.up);
    EXPECT_EQ(together.down, alone.down);
  }
}

//     0 -> 1 -> 2 -> 3      each arc costs `cost`
Instance chain(Millis cost) { return make_instance(4, {{0, 1, cost}, {1, 2, cost}, {2, 3, cost}}); }

TEST(Cch, SumsThatFillTheWidthAreExact) {
  const auto end = vertices({3});
  const auto all = vertices({0, 1, 2, 3});
  const auto check = [&](Millis cost, bool fits) {
    const Instance instance = chain(cost);
    const CchTopology topology(instance.graph, vertices({1, 2, 0, 3}));
    EXPECT_EQ(fits_32_bits(instance.graph, instance.costs), fits) << cost;
    CchOracle<W64>().check(topology, instance, end, all);
    if (fits) CchOracle<W32>().check(topology, instance, end, all);
  };
  check(0, true);
  check(limit32 / 3 - 1, true);
  check(limit32 / 3 + 1, false);
  check(limit32, false);
  check(3 * limit32, false);
  check(infinity / 3, false);
  check(infinity / 3 + 1, false);  // the whole saturates, two thirds of it do not
  check(infinity - 1, false);
  check(infinity, true);  // closed
}

//     0 <-> 1 <-> 2 <-> ..      a long chain: all its arcs together are too much for 32 bits, no way along it
//     is
TEST(Cch, AWidthThatShortestWaysNeedIsSeenInTheMetric) {
  std::vector<ArcEnds> arcs;
  for (std::size_t v = 0; v + 1 < 100; ++v) {
    arcs.push_back({.tail = VertexId{v}, .head = VertexId{v + 1}});
    arcs.push_back({.tail = VertexId{v + 1}, .head = VertexId{v}});
    arcs.push_back({.tail = VertexId{v}, .head = VertexId{v + 1}});  // nobody would take it
  }
  Instance instance{.graph = Digraph(100, arcs), .costs = std::vector<Millis>(arcs.size(), 1'000)};
  for (std::size_t i = 2; i < arcs.size(); i += 3) instance.costs[i] = limit32 / 10;
  const CchTopology topology = topology_of(instance.graph);
  const auto fits = [&] {
    CchMetric<W32> metric;
    metric.customise(topology, instance.costs);
    return fits_32_bits(instance.graph, instance.costs, topology, metric);
  };
  EXPECT_FALSE(fits_32_bits(instance.graph, instance.costs));
  EXPECT_TRUE(fits());
  CchOracle<W32>().check(topology, instance, every_vertex(instance.graph), every_vertex(instance.graph));
  instance.costs[0] = limit32 + 7;  // from 0 to 1 by the other one
  EXPECT_TRUE(fits());
  instance.costs[2] = limit32 - 1;  // and now not at all within 32 bits
  EXPECT_FALSE(fits());
}

TEST(Cch, WhatIsTooFarFor32BitsIsNeverNear) {
  for (const Millis cost : {limit32 / 2, limit32 - 1, limit32, limit32 + 5, 4 * limit32 + 1, infinity - 1}) {
    const Instance instance = chain(cost);
    const CchTopology topology(instance.graph, vertices({1, 2, 0, 3}));
    CchMetric<W32> metric;
    metric.customise(topology, instance.costs);
    const VertexId end{3};
    CchSweep<W32> sweep;
    sweep.run(topology, metric, {&end, 1});
    CchLoneSearch<W32> lone;
    lone.start(topology, metric, end);
    EXPECT_GE(sweep.cost(topology, VertexId{0}, 0), cch_infinity<W32>) << cost;
    EXPECT_GE(lone.cost(topology, metric, VertexId{0}), cch_infinity<W32>) << cost;
  }
}

//     0 -> 1 -> 3 -> 4      over 1 or over 2: as dear as each other until 2 -> 3 costs one more; then 0 -> 3
//      +-> 2 ---^           itself costs as much as the way over 1
TEST(Cch, TheOnlyWayIsToldFromOneOfSeveral) {
  const auto only_way = [](Millis last_of_other, Millis direct, std::initializer_list<std::uint32_t> order) {
    const Instance net = make_instance(
        5, {{0, 1, 2}, {0, 2, 2}, {1, 3, 2}, {2, 3, last_of_other}, {0, 3, direct}, {3, 4, 7}, {3, 4, 7}});
    const CchTopology topology(net.graph, postordered(net.graph, vertices(order)));
    CchMetric<W32> metric;
    metric.customise(topology, net.costs);
    CchLoneSearch<W32> search;
    search.start(topology, metric, VertexId{4});
    EXPECT_EQ(search.cost(topology, metric, VertexId{0}), 11U);
    std::vector<VertexId> way;
    const bool is_only = search.only_way(net.graph, net.costs, topology, metric, VertexId{0}, way);
    EXPECT_EQ(is_only, !way.empty());
    return way;
  };
  // Where ways part and meet: above both, in between, below both.
  for (const auto order :
       {std::initializer_list<std::uint32_t>{1, 2, 0, 3, 4}, {0, 1, 2, 3, 4}, {0, 4, 3, 1, 2}}) {
    EXPECT_TRUE(only_way(2, 9, order).empty());
    EXPECT_EQ(only_way(3, 9, order), vertices({1, 3, 4})) << "the double arc is one way";
    EXPECT_TRUE(only_way(3, 4, order).empty());
  }
}

//     0 -> 1 <-> 2 -> 4       all but 2 -> 4 costs nothing: from 1 the way down lies beyond a plateau with
//          |     |            circles
//          3 <---+
TEST(NextHops, CrossesAPlateauWithoutGoingRound) {
  const Instance plateau = make_instance(
      5, {{0, 1, 0}, {1, 3, 0}, {3, 1, 0}, {1, 2, 0}, {2, 1, 0}, {2, 3, 0}, {2, 4, 9}, {0, 0, 0}});
  const std::array<Millis, 5> label{9, 9, 9, 9, 0};
  std::vector<VertexId> way;
  walk_next_hops(
      plateau.graph, plateau.costs, VertexId{0}, VertexId{4}, [&](VertexId v) { return label[v.value]; },
      way);
  EXPECT_EQ(way, vertices({1, 2, 4}));
}

TEST(Fingerprint, KnowsTheGraphByItsArcsAndTheirOrder) {
  const auto of = [](std::size_t count, std::initializer_list<WeightedArc> arcs) {
    return fingerprint(make_instance(count, arcs).graph);
  };
  const auto original = of(3, {{0, 1}, {1, 2}});
  EXPECT_EQ(original, of(3, {{0, 1}, {1, 2}}));
  EXPECT_NE(original, of(4, {{0, 1}, {1, 2}}));
  EXPECT_NE(original, of(3, {{1, 2}, {0, 1}}));
  EXPECT_NE(original, of(3, {{0, 1}, {2, 1}}));
  EXPECT_NE(original, of(3, {{0, 1}}));
}

}  // namespace
}  // namespace thalweg::testing
