// SPDX-License-Identifier: Apache-2.0
#include "routing/potentials.hpp"

#include <gtest/gtest.h>

#include "search/dijkstra.hpp"
#include "support/random_graph.hpp"

namespace thalweg::testing {
namespace {

// Against Dijkstra's algorithm, before and after the costs change and an arc is closed.
TEST(Potentials, AreTheLeastTimeThatIsLeft) {
  Potentials::Search search;
  Tree tree;
  DijkstraScratch scratch;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Instance instance = random_instance(static_cast<InstanceType>(seed % 3), seed);
    Potentials potentials(instance.graph, {});
    for (int round = 0; round < 2; ++round) {
      potentials.refresh(instance.costs, instance.costs, 1 + seed % 2);
      for (std::size_t to = 0; to < instance.graph.vertex_count(); ++to) {
        const VertexId destination{to};
        dijkstra<Direction::backward>(instance.graph, {&destination, 1}, instance, tree, scratch);
        potentials.start(search, destination);
        for (std::size_t from = 0; from < instance.graph.vertex_count(); ++from)
          ASSERT_EQ(potentials.left(search, VertexId{from}, 0, infinity), tree.label[VertexId{from}]) << seed;
      }
      for (std::size_t arc = 0; arc < instance.costs.size(); ++arc)
        instance.costs[arc] = arc == 0 ? infinity : instance.costs[arc] + static_cast<Millis>(arc % 3);
    }
  }
}

//     0 --100, 60 at the best time--> 1 --100, 60--> 2
TEST(Potentials, AllowForSoMuchLuckAsTheTimeThatSignalsAreKnownFor) {
  const std::vector<ArcEnds> arcs{{VertexId{0U}, VertexId{1U}}, {VertexId{1U}, VertexId{2U}}};
  const Digraph graph(3, arcs);
  Potentials potentials(graph, {});
  potentials.refresh({60, 60}, {100, 100}, 1);
  Potentials::Search search;
  potentials.start(search, VertexId{2U});
  const auto left = [&](Millis known, Millis most) {
    return potentials.left(search, VertexId{0U}, known, most);
  };
  EXPECT_EQ(left(-10, infinity), 200) << "nothing is known any more";
  EXPECT_EQ(left(50, infinity), 190) << "a fifth of what is known";
  EXPECT_EQ(left(1'000, infinity), 120) << "not below the best time";
  EXPECT_GT(left(1'000, -10), -10) << "above what matters, however far";
  potentials.start(search, VertexId{0U});
  EXPECT_EQ(potentials.left(search, VertexId{2U}, 1'000, infinity), infinity) << "no way";
}

}  // namespace
}  // namespace thalweg::testing
