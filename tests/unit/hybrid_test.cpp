// SPDX-License-Identifier: Apache-2.0
#include "search/hybrid.hpp"

#include <gtest/gtest.h>

#include "search/hybrid_in_one_pass.hpp"
#include "support/instance.hpp"
#include "support/random_graph.hpp"

namespace thalweg {
namespace {

using testing::arcs;
using testing::Instance;
using testing::make_instance;
using testing::vertices;
using Labels = IdVector<VertexId, Millis>;

template <Direction direction>
Tree hybrid_tree(const Instance& instance, std::initializer_list<std::uint32_t> sources,
                 Criterion criterion = Criterion::minimum) {
  Regions regions;
  Tree tree;
  partition<direction>(instance.graph, vertices(sources), regions);
  hybrid<direction>(instance.graph, regions, instance, tree, criterion);
  return tree;
}

//   0 --4--> 1 --1--> 3        by number of arcs both ways to 3 are equal, and 0-1-3 is cheaper;
//   0 --1--> 2 --9--> 3        2 is cheaper over 1 (4 + 0), but that has one arc more
//            1 --0--> 2        4 leads in, but nothing leads to it
//   4 --0--> 3
const Instance& diamond() {
  static const Instance instance =
      make_instance(5, {{0, 1, 4}, {1, 3, 1}, {0, 2, 1}, {2, 3, 9}, {1, 2, 0}, {4, 3, 0}});
  return instance;
}

TEST(Hybrid, TakesTheCheapestOfTheFewestArcPaths) {
  const Tree tree = hybrid_tree<Direction::forward>(diamond(), {0});
  EXPECT_EQ(tree.label, (Labels{0, 4, 1, 5, infinity}));
  EXPECT_EQ(path<Direction::forward>(diamond().graph, tree, VertexId{3U}), arcs({0, 1}));
  EXPECT_EQ(path<Direction::forward>(diamond().graph, tree, VertexId{4U}), std::nullopt);
}

TEST(Hybrid, MaximumTakesTheDearest) {
  const Tree tree = hybrid_tree<Direction::forward>(diamond(), {0}, Criterion::maximum);
  EXPECT_EQ(tree.label, (Labels{0, 4, 1, 10, infinity}));
  EXPECT_EQ(path<Direction::forward>(diamond().graph, tree, VertexId{3U}), arcs({2, 3}));
}

TEST(Hybrid, BackwardPathsLeadToTheRootInDrivingOrder) {
  const Tree tree = hybrid_tree<Direction::backward>(diamond(), {3});
  EXPECT_EQ(tree.label, (Labels{5, 1, 9, 0, 0}));
  EXPECT_EQ(path<Direction::backward>(diamond().graph, tree, VertexId{0U}), arcs({0, 1}));
  EXPECT_EQ(path<Direction::backward>(diamond().graph, tree, VertexId{3U}), arcs({}));
}

//   0 --9--> 2     the detour over 1 costs 2: an anti event, which hybrid does not see
//   0 --1--> 1 --1--> 2
TEST(Hybrid, KeepsTheFewestArcsWhenADetourIsCheaper) {
  const auto instance = make_instance(3, {{0, 2, 9}, {0, 1, 1}, {1, 2, 1}});
  EXPECT_EQ(hybrid_tree<Direction::forward>(instance, {0}).label[VertexId{2U}], 9);
}

//   0 ==1==> 1, three parallel arcs of which two cost the same
TEST(Hybrid, OfEqualsTheLowestArcWins) {
  const auto instance = make_instance(2, {{0, 1, 2}, {0, 1, 1}, {0, 1, 1}});
  EXPECT_EQ(hybrid_tree<Direction::forward>(instance, {0}).parent[VertexId{1U}], ArcId{1U});
  EXPECT_EQ(hybrid_tree<Direction::backward>(instance, {1}).parent[VertexId{0U}], ArcId{1U});
  const auto equal = make_instance(2, {{0, 1, 3}, {0, 1, 3}});
  EXPECT_EQ(hybrid_tree<Direction::forward>(equal, {0}, Criterion::maximum).parent[VertexId{1U}], ArcId{0U});
}

//   0 --closed--> 1 --1--> 2
//   0 --closed--> 3, 0 --5--> 3
TEST(Hybrid, AClosedArcIsNoWay) {
  const auto instance = make_instance(4, {{0, 1, infinity}, {1, 2, 1}, {0, 3, infinity}, {0, 3, 5}});
  for (const Criterion criterion : {Criterion::minimum, Criterion::maximum}) {
    const Tree tree = hybrid_tree<Direction::forward>(instance, {0}, criterion);
    EXPECT_EQ(tree.label, (Labels{0, infinity, infinity, 5}));
    EXPECT_FALSE(tree.parent[VertexId{1U}].valid());
    EXPECT_FALSE(tree.parent[VertexId{2U}].valid());
    EXPECT_EQ(tree.parent[VertexId{3U}], ArcId{3U});
  }
}

//   0 --7--> 2 <--3-- 1
TEST(Hybrid, EveryRootHasLabelZero) {
  const auto instance = make_instance(3, {{0, 2, 7}, {1, 2, 3}, {0, 1, 0}});
  const Tree tree = hybrid_tree<Direction::forward>(instance, {0, 1});
  EXPECT_EQ(tree.label, (Labels{0, 0, 3}));
  EXPECT_FALSE(tree.parent[VertexId{1U}].valid());
}

TEST(Hybrid, OfNothingAndOfOneVertex) {
  EXPECT_TRUE(hybrid_tree<Direction::forward>(make_instance(0, {}), {}).label.empty());
  EXPECT_EQ(hybrid_tree<Direction::forward>(make_instance(2, {{0, 1}}), {}).label,
            (Labels{infinity, infinity}));
  EXPECT_EQ(hybrid_tree<Direction::forward>(make_instance(1, {{0, 0, 0}}), {0}).label, (Labels{0}));
}

/// The best (sign 1) or worst (sign -1) cost over the fewest-arc paths, by the definition: every path of
/// region number - 1 arcs, one arc at a time, without regions to walk.
std::vector<Millis> by_definition(const Instance& instance, const std::vector<Millis>& fewest, int sign) {
  std::vector<Millis> best(fewest.size(), infinity);
  best[0] = 0;
  for (std::size_t length = 1; length < fewest.size(); ++length) {
    for (std::size_t i = 0; i < instance.costs.size(); ++i) {
      const auto [tail, head] = instance.graph.ends(ArcId{i});
      if (fewest[head.value] != static_cast<Millis>(length) || fewest[tail.value] + 1 != fewest[head.value])
        continue;
      if (best[tail.value] >= infinity || instance.costs[i] >= infinity) continue;
      const Millis sum = best[tail.value] + instance.costs[i];
      if (best[head.value] >= infinity || sign * sum < sign * best[head.value]) best[head.value] = sum;
    }
  }
  return best;
}

// The paper's second theorem, and its mirror.
TEST(Hybrid, IsOptimalAmongTheFewestArcPaths) {
  for (std::uint64_t seed = 0; seed < 1'000; ++seed) {
    const auto instance = testing::random_instance(InstanceType::mixed, seed);
    Instance unit = instance;
    unit.costs.assign(unit.costs.size(), 1);
    const auto fewest = testing::least_costs(unit, VertexId{0U}, Direction::forward);
    for (const Criterion criterion : {Criterion::minimum, Criterion::maximum}) {
      const Tree tree = hybrid_tree<Direction::forward>(instance, {0}, criterion);
      const auto expected = by_definition(instance, fewest, criterion == Criterion::minimum ? 1 : -1);
      for (std::size_t i = 0; i < fewest.size(); ++i) {
        ASSERT_EQ(tree.label[VertexId{i}], expected[i]) << "seed " << seed << " vertex " << i;
        const auto found = path<Direction::forward>(instance.graph, tree, VertexId{i});
        if (found) {
          ASSERT_EQ(static_cast<Millis>(found->size()), fewest[i]);
        }
      }
    }
  }
}

template <Direction direction>
void expect_one_pass_equals_two(const Instance& instance, std::span<const VertexId> sources,
                                MarkedRegions& at_once) {
  Regions regions;
  Tree tree;
  partition<direction>(instance.graph, sources, regions);
  hybrid<direction>(instance.graph, regions, instance, tree);
  partition_and_hybrid<direction>(instance.graph, sources, instance, at_once);
  ASSERT_EQ(at_once.order, regions.order);
  ASSERT_EQ(at_once.first, regions.first);
  ASSERT_EQ(at_once.marks.size(), instance.graph.vertex_count());
  for (std::size_t i = 0; i < at_once.marks.size(); ++i) {
    const VertexId v{i};
    ASSERT_EQ(at_once.marks[v].number, regions.number[v]);
    ASSERT_EQ(at_once.marks[v].label, tree.label[v]);
    ASSERT_EQ(at_once.marks[v].parent, tree.parent[v]);
  }
}

// Equal costs, closed arcs, parallel arcs, loops and several sources included.
TEST(HybridInOnePass, EqualsPartitionAndHybridToTheLastParent) {
  MarkedRegions at_once;  // used again: what is left over from another graph must not show
  for (std::uint64_t seed = 0; seed < 1'000; ++seed) {
    for (const InstanceType type : {InstanceType::mixed, InstanceType::simple, InstanceType::directed}) {
      const Instance instance = testing::random_instance(type, seed);
      const auto last = static_cast<std::uint32_t>(instance.graph.vertex_count() - 1);
      for (const auto& sources : {vertices({0}), vertices({last, 0, last})}) {
        expect_one_pass_equals_two<Direction::forward>(instance, sources, at_once);
        expect_one_pass_equals_two<Direction::backward>(instance, sources, at_once);
      }
      ASSERT_FALSE(HasFatalFailure()) << "seed " << seed;
    }
  }
  expect_one_pass_equals_two<Direction::forward>(make_instance(0, {}), {}, at_once);
  expect_one_pass_equals_two<Direction::forward>(make_instance(2, {{0, 1}}), {}, at_once);
}

}  // namespace
}  // namespace thalweg
