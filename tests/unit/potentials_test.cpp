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
      potentials.refresh(instance.costs, 1 + seed % 2);
      for (std::size_t to = 0; to < instance.graph.vertex_count(); ++to) {
        const VertexId destination{to};
        dijkstra<Direction::backward>(instance.graph, {&destination, 1}, instance, tree, scratch);
        potentials.start(search, destination);
        for (std::size_t from = 0; from < instance.graph.vertex_count(); ++from)
          ASSERT_EQ(potentials.left(search, VertexId{from}), tree.label[VertexId{from}]) << seed;
      }
      for (std::size_t arc = 0; arc < instance.costs.size(); ++arc)
        instance.costs[arc] = arc == 0 ? infinity : instance.costs[arc] + static_cast<Millis>(arc % 3);
    }
  }
}

}  // namespace
}  // namespace thalweg::testing
