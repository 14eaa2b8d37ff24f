// SPDX-License-Identifier: Apache-2.0
#include "search/dijkstra.hpp"

#include "routing/list.hpp"
#include "routing/service_tree.hpp"

namespace thalweg {
namespace {

struct DijkstraSearch {
  DijkstraScratch scratch;

  void operator()(const Digraph& graph, const std::vector<Millis>& costs, VertexId destination,
                  std::span<const VertexId> origins, Tree& out) {
    dijkstra<Direction::backward>(
        graph, {&destination, 1}, [&](ArcId arc) { return costs[arc.value]; }, out, scratch, origins);
  }
};

}  // namespace

std::unique_ptr<Strategy> make_dijkstra(const StrategyOptions& options) {
  return std::make_unique<ServiceTreeStrategy<DijkstraSearch>>(options);
}

}  // namespace thalweg
