// SPDX-License-Identifier: Apache-2.0
#include "search/instance.hpp"

#include <gtest/gtest.h>

#include <set>

#include "search/regions.hpp"
#include "support/instance.hpp"
#include "support/random_graph.hpp"

namespace thalweg {
namespace {

using testing::make_instance;
using testing::random_instance;

InstanceType type_of(std::size_t vertices, std::initializer_list<testing::WeightedArc> arcs) {
  return instance_type(make_instance(vertices, arcs).graph);
}

TEST(InstanceType, OfSmallGraphs) {
  EXPECT_EQ(type_of(0, {}), InstanceType::simple);
  EXPECT_EQ(type_of(2, {}), InstanceType::simple);
  EXPECT_EQ(type_of(1, {{0, 0}}), InstanceType::simple) << "a loop is its own reverse";
  EXPECT_EQ(type_of(2, {{0, 1}, {1, 0}}), InstanceType::simple);
  EXPECT_EQ(type_of(2, {{0, 1}, {0, 1}, {1, 0}}), InstanceType::simple) << "one reverse serves parallel arcs";
  EXPECT_EQ(type_of(2, {{0, 1}, {0, 1}}), InstanceType::directed);
  EXPECT_EQ(type_of(3, {{0, 1}, {1, 2}, {2, 0}}), InstanceType::directed);
  EXPECT_EQ(type_of(3, {{0, 1}, {1, 0}, {1, 2}}), InstanceType::mixed);
  EXPECT_EQ(type_of(2, {{0, 1}, {1, 1}}), InstanceType::mixed);
}

/// Whether a graph has the trouble that the random graphs promise.
struct Trouble {
  std::size_t lonely = 0;
  std::size_t loops = 0;
  std::size_t parallel = 0;
  std::size_t free = 0;
};

TEST(RandomGraph, HasItsTypeAndItsTrouble) {
  for (const InstanceType type : {InstanceType::mixed, InstanceType::simple, InstanceType::directed}) {
    Trouble trouble;
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
      const auto instance = random_instance(type, seed);
      if (type != InstanceType::simple || instance.graph.arc_count() > 0) {
        ASSERT_EQ(instance_type(instance.graph), type) << "seed " << seed;
      }
      std::set<ArcEnds> seen;
      for (std::size_t i = 0; i < instance.graph.arc_count(); ++i) {
        const ArcEnds ends = instance.graph.ends(ArcId{i});
        trouble.loops += ends.tail == ends.head ? 1U : 0U;
        trouble.parallel += seen.insert(ends).second ? 0U : 1U;
        trouble.free += instance.costs[i] == 0 ? 1U : 0U;
      }
      for (std::size_t i = 0; i < instance.graph.vertex_count(); ++i) {
        const VertexId v{i};
        trouble.lonely += instance.graph.out(v).empty() && instance.graph.in(v).empty() ? 1U : 0U;
      }
    }
    EXPECT_GT(trouble.lonely, 100U);
    EXPECT_GT(trouble.parallel, 100U);
    EXPECT_GT(trouble.free, 100U);
    EXPECT_EQ(trouble.loops > 100U, type != InstanceType::directed);
  }
}

//   0 --> 1 --> 2 --> 0      3 <--> 4 --> 5       2 --> 3
TEST(StrongComponents, AreNumberedFromTheSinks) {
  const auto instance = make_instance(6, {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 3}, {4, 5}, {2, 3}});
  const Components components = strong_components(instance.graph);
  EXPECT_EQ(components.count, 3U);
  EXPECT_EQ(components.number, (IdVector<VertexId, std::uint32_t>{2, 2, 2, 1, 1, 0}));
}

TEST(StrongComponents, OfNothingAndOfOneVertex) {
  EXPECT_EQ(strong_components(Digraph{}).count, 0U);
  EXPECT_EQ(strong_components(make_instance(1, {{0, 0}}).graph).count, 1U);
}

// By definition: together if and only if each reaches the other.
TEST(StrongComponents, JoinWhatReachesEachOther) {
  Regions regions;
  std::size_t joined = 0;
  std::size_t parted = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const auto type = seed % 2 == 0 ? InstanceType::mixed : InstanceType::directed;
    const auto instance = random_instance(type, seed);
    const std::size_t n = instance.graph.vertex_count();
    std::vector<std::vector<bool>> reaches(n, std::vector<bool>(n));
    for (std::size_t i = 0; i < n; ++i) {
      const VertexId source{i};
      partition<Direction::forward>(instance.graph, std::span(&source, 1), regions);
      for (const VertexId v : regions.order) reaches[i][v.value] = true;
    }
    const Components components = strong_components(instance.graph);
    std::set<std::uint32_t> numbers(components.number.begin(), components.number.end());
    ASSERT_EQ(numbers.size(), components.count);
    ASSERT_EQ(*numbers.rbegin() + 1, components.count);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        const std::uint32_t a = components.number[VertexId{i}];
        const std::uint32_t b = components.number[VertexId{j}];
        ASSERT_EQ(a == b, reaches[i][j] && reaches[j][i]) << "seed " << seed << ": " << i << ", " << j;
        if (reaches[i][j]) {
          ASSERT_GE(a, b);
        }
        if (i != j) ++(a == b ? joined : parted);
      }
    }
  }
  EXPECT_GT(joined, 1'000U);
  EXPECT_GT(parted, 1'000U);
}

// The recursive form would need a stack frame a vertex.
TEST(StrongComponents, StandALongChain) {
  constexpr std::size_t length = 1'000'000;
  std::vector<ArcEnds> arcs;
  for (std::size_t i = 0; i + 1 < length; ++i) arcs.push_back({.tail = VertexId{i}, .head = VertexId{i + 1}});
  EXPECT_EQ(strong_components(Digraph(length, arcs)).count, length);
}

}  // namespace
}  // namespace thalweg
