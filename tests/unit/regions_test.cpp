// SPDX-License-Identifier: Apache-2.0
#include "search/regions.hpp"

#include <gtest/gtest.h>

#include "support/instance.hpp"
#include "support/random_graph.hpp"

namespace thalweg {
namespace {

using testing::make_instance;
using testing::random_instance;
using testing::vertices;

std::vector<VertexId> as_vector(std::span<const VertexId> span) { return {span.begin(), span.end()}; }

//   0 --> 1 --> 3 <--> 4      5 --> 0     6
//   '---> 2 ----^
TEST(Partition, LevelsByArcsFromTheSource) {
  const auto instance = make_instance(7, {{0, 1}, {0, 2}, {1, 3}, {2, 3}, {3, 4}, {4, 3}, {5, 0}});
  Regions regions;
  partition<Direction::forward>(instance.graph, vertices({0}), regions);
  EXPECT_EQ(regions.number, (IdVector<VertexId, std::uint32_t>{1, 2, 2, 3, 4, 0, 0}));
  EXPECT_EQ(regions.order, vertices({0, 1, 2, 3, 4}));
  EXPECT_EQ(regions.first, (std::vector<std::uint32_t>{0, 1, 3, 4, 5}));
  EXPECT_EQ(as_vector(regions.region(2)), vertices({1, 2}));
}

// The same graph against the arcs: who reaches 3, and by how many.
TEST(Partition, BackwardLevelsByArcsToTheSource) {
  const auto instance = make_instance(7, {{0, 1}, {0, 2}, {1, 3}, {2, 3}, {3, 4}, {4, 3}, {5, 0}});
  Regions regions;
  partition<Direction::backward>(instance.graph, vertices({3}), regions);
  EXPECT_EQ(regions.number, (IdVector<VertexId, std::uint32_t>{3, 2, 2, 1, 2, 4, 0}));
}

//   0 --> 1 --> 2 --> 3
TEST(Partition, EndsAfterTheRegionInWhichTheLastWantedVertexIs) {
  const auto instance = make_instance(5, {{0, 1}, {1, 2}, {2, 3}});
  const auto regions_until = [&](std::initializer_list<std::uint32_t> until) {
    Regions regions;
    partition<Direction::forward>(instance.graph, vertices({0}), regions, vertices(until));
    return regions.count();
  };
  EXPECT_EQ(regions_until({0}), 1U);
  EXPECT_EQ(regions_until({2, 1, 2}), 3U);
  EXPECT_EQ(regions_until({1, 4}), 4U) << "4 is out of reach: to the end";
  EXPECT_EQ(regions_until({}), 4U);
}

TEST(Partition, StoppingLeavesWholeRegionsAsTheyAre) {
  Regions full;
  Regions stopped;
  std::size_t shorter = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const auto instance = random_instance(InstanceType::mixed, seed);
    partition<Direction::forward>(instance.graph, vertices({0}), full);
    const VertexId wanted = full.order[full.order.size() / 2];
    partition<Direction::forward>(instance.graph, vertices({0}), stopped, std::span(&wanted, 1));
    ASSERT_EQ(stopped.count(), full.number[wanted]);
    ASSERT_EQ(stopped.order.size(), full.first[stopped.count()]);
    ASSERT_TRUE(std::equal(stopped.order.begin(), stopped.order.end(), full.order.begin()));
    shorter += stopped.count() < full.count() ? 1U : 0U;
  }
  EXPECT_GT(shorter, 100U);
}

//   0 --> 2 <-- 1      two sources, one of them named twice
TEST(Partition, TakesSeveralSourcesAndEachOnce) {
  const auto instance = make_instance(3, {{0, 2}, {1, 2}});
  Regions regions;
  partition<Direction::forward>(instance.graph, vertices({1, 0, 1}), regions);
  EXPECT_EQ(regions.order, vertices({1, 0, 2}));
  EXPECT_EQ(regions.first, (std::vector<std::uint32_t>{0, 2, 3}));
}

TEST(Partition, OfNothingAndOfOneVertex) {
  Regions regions;
  partition<Direction::forward>(Digraph{}, {}, regions);
  EXPECT_EQ(regions.count(), 0U);
  EXPECT_TRUE(regions.order.empty());
  partition<Direction::forward>(make_instance(1, {{0, 0}}).graph, vertices({0}), regions);
  EXPECT_EQ(regions.order, vertices({0}));
  EXPECT_EQ(regions.count(), 1U);
}

// The paper's shortest path theorem (N-shortest). The fewest arcs come from the definition of least cost,
// with every cost 1.
template <Direction direction>
void expect_numbers_are_fewest_arcs() {
  Regions regions;
  std::uint32_t deepest = 0;
  for (const InstanceType type : {InstanceType::mixed, InstanceType::simple, InstanceType::directed}) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
      auto instance = random_instance(type, seed);
      instance.costs.assign(instance.costs.size(), 1);
      partition<direction>(instance.graph, vertices({0}), regions);
      const auto fewest = testing::least_costs(instance, VertexId{0U}, direction);
      for (std::size_t i = 0; i < fewest.size(); ++i) {
        const Millis number = regions.number[VertexId{i}];
        ASSERT_EQ(number == 0 ? infinity : number - 1, fewest[i]) << "seed " << seed << " vertex " << i;
      }
      deepest = std::max(deepest, regions.count());
    }
  }
  EXPECT_GT(deepest, 6U);
}
TEST(Partition, NumberMinusOneIsTheFewestArcs) {
  expect_numbers_are_fewest_arcs<Direction::forward>();
  expect_numbers_are_fewest_arcs<Direction::backward>();
}

TEST(FirstForm, EqualsTheSecondWhereEveryArcHasItsReverse) {
  Regions first;
  Regions second;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const auto instance = random_instance(InstanceType::simple, seed);
    EXPECT_TRUE(partition_first_form<Direction::forward>(instance.graph, vertices({0, 0}), first));
    partition<Direction::forward>(instance.graph, vertices({0}), second);
    ASSERT_EQ(first.order, second.order) << "seed " << seed;
    ASSERT_EQ(first.first, second.first) << "seed " << seed;
    ASSERT_EQ(first.number, second.number) << "seed " << seed;
  }
}

//   0 --> 1 --> 2 --> 3 --> 4
//   '-----------------------^     4 is in region 2, and again behind 3
TEST(FirstForm, AdmitsAVertexOfAnOldRegionAgain) {
  const auto instance = make_instance(5, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {0, 4}});
  Regions regions;
  EXPECT_TRUE(partition_first_form<Direction::forward>(instance.graph, vertices({0}), regions));
  EXPECT_EQ(regions.order, vertices({0, 1, 4, 2, 3, 4}));
  EXPECT_EQ(regions.number[VertexId{4U}], 5U);
  partition<Direction::forward>(instance.graph, vertices({0}), regions);
  EXPECT_EQ(regions.number[VertexId{4U}], 2U);
}

//   0 --> 1 --> 2 --> 0
TEST(FirstForm, RunsRoundACycleUntilItIsStopped) {
  const auto instance = make_instance(3, {{0, 1}, {1, 2}, {2, 0}});
  Regions regions;
  EXPECT_FALSE(partition_first_form<Direction::forward>(instance.graph, vertices({0}), regions, 5));
  EXPECT_EQ(regions.order, vertices({0, 1, 2, 0, 1}));
  EXPECT_FALSE(partition_first_form<Direction::backward>(instance.graph, vertices({0}), regions));
  EXPECT_EQ(regions.order, vertices({0, 2, 1})) << "the bound by default is the number of vertices";
}

// The paper: O(4 E) for the optimised form. Here at most two table operations an arc, the source's own entry
// (a read and a write) apart.
TEST(Partition, TakesAtMostFourTableOperationsAnArc) {
  Regions counted;
  Regions plain;
  PartitionOperations operations;
  const VertexId source{0U};
  std::uint64_t most = 0;
  for (const InstanceType type : {InstanceType::mixed, InstanceType::simple, InstanceType::directed}) {
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
      const auto instance = random_instance(type, seed);
      partition<Direction::forward>(instance.graph, {&source, 1}, counted, operations);
      partition<Direction::forward>(instance.graph, {&source, 1}, plain);
      ASSERT_EQ(counted.order, plain.order);
      std::uint64_t reached_arcs = 0;
      for (const VertexId v : plain.order) reached_arcs += instance.graph.out(v).size();
      ASSERT_EQ(operations.table, reached_arcs + plain.order.size() + 1) << "seed " << seed;
      ASSERT_LE(operations.table - 2, 4 * instance.graph.arc_count()) << "seed " << seed;
      most = std::max(most, operations.table);
    }
  }
  EXPECT_GT(most, 50U);
}

//   0 <-> 1 <-> 2      2 is compared with regions {1} and {0}; the rest is looked for in vain or found at
//   once
TEST(FirstForm, CountsItsComparisons) {
  const auto instance = make_instance(3, {{0, 1}, {1, 0}, {1, 2}, {2, 1}});
  Regions regions;
  PartitionOperations operations;
  EXPECT_TRUE(
      partition_first_form<Direction::forward>(instance.graph, vertices({0}), regions, 0, &operations));
  // 1 against {0}; 0 against {1}, {0}; 2 against {1}, {0}; 1 against {2}, {1}
  EXPECT_EQ(operations.comparisons, 1U + 2U + 2U + 2U);
  EXPECT_EQ(operations.table, 0U);
}

}  // namespace
}  // namespace thalweg
