// SPDX-License-Identifier: Apache-2.0
#include "search/dijkstra.hpp"

#include <gtest/gtest.h>

#include "support/instance.hpp"

namespace thalweg {
namespace {

using testing::arcs;
using testing::Instance;
using testing::make_instance;
using testing::vertices;
using Labels = IdVector<VertexId, Millis>;

template <Direction direction>
Tree dijkstra_tree(const Instance& instance, std::initializer_list<std::uint32_t> sources,
                   std::initializer_list<std::uint32_t> targets = {}) {
  Tree tree;
  DijkstraScratch scratch;
  dijkstra<direction>(instance.graph, vertices(sources), instance, tree, scratch, vertices(targets));
  return tree;
}

//   0 --9--> 2 --1--> 3 --1--> 4        0-1-2 costs 2
//   0 --1--> 1 --1--> 2
const Instance& detour() {
  static const Instance instance = make_instance(6, {{0, 2, 9}, {0, 1, 1}, {1, 2, 1}, {2, 3, 1}, {3, 4, 1}});
  return instance;
}

TEST(Dijkstra, TakesTheCheaperDetour) {
  const Tree tree = dijkstra_tree<Direction::forward>(detour(), {0});
  EXPECT_EQ(tree.label, (Labels{0, 1, 2, 3, 4, infinity}));
  EXPECT_EQ(path<Direction::forward>(detour().graph, tree, VertexId{3U}), arcs({1, 2, 3}));
  EXPECT_EQ(dijkstra_tree<Direction::backward>(detour(), {3}).label,
            (Labels{3, 2, 1, 0, infinity, infinity}));
}

TEST(Dijkstra, StopsWhenTheTargetsAreSettled) {
  EXPECT_EQ(dijkstra_tree<Direction::forward>(detour(), {0}, {1}).label,
            (Labels{0, 1, 9, infinity, infinity, infinity}))
      << "2 has an upper bound only";
  EXPECT_EQ(dijkstra_tree<Direction::forward>(detour(), {0}, {2, 1}).label[VertexId{4U}], infinity);
  EXPECT_EQ(dijkstra_tree<Direction::forward>(detour(), {0}, {1, 5}).label[VertexId{4U}], 4)
      << "5 is out of reach: to the end";
}

//   0 --1--> 1 --1--> 3,  0 --1--> 2 --1--> 3: 1 is settled before 2
TEST(Dijkstra, OfEqualsTheFirstFoundWins) {
  const auto instance = make_instance(4, {{2, 3}, {0, 2}, {0, 1}, {1, 3}});
  EXPECT_EQ(dijkstra_tree<Direction::forward>(instance, {0}).parent[VertexId{3U}], ArcId{3U});
}

//   0 --closed--> 1 --1--> 2;  2 --0--> 2
TEST(Dijkstra, AClosedArcIsNoWay) {
  const auto instance = make_instance(3, {{0, 1, infinity}, {1, 2, 1}, {2, 2, 0}});
  const Tree tree = dijkstra_tree<Direction::forward>(instance, {0});
  EXPECT_EQ(tree.label, (Labels{0, infinity, infinity}));
  EXPECT_FALSE(tree.parent[VertexId{1U}].valid());
}

//   0 --7--> 2 <--3-- 1
TEST(Dijkstra, EveryRootHasLabelZero) {
  const auto instance = make_instance(3, {{0, 2, 7}, {1, 2, 3}, {0, 1, 0}});
  EXPECT_EQ(dijkstra_tree<Direction::forward>(instance, {1, 0, 1}).label, (Labels{0, 0, 3}));
}

TEST(Dijkstra, OfNothingAndOfOneVertex) {
  EXPECT_TRUE(dijkstra_tree<Direction::forward>(make_instance(0, {}), {}).label.empty());
  EXPECT_EQ(dijkstra_tree<Direction::forward>(make_instance(1, {{0, 0, 0}}), {0}, {0}).label, (Labels{0}));
}

}  // namespace
}  // namespace thalweg
