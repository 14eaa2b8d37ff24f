// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "core/time.hpp"
#include "graph/digraph.hpp"

namespace thalweg::bench {

/// Boost.Graph's dijkstra_shortest_paths on compressed rows, ended when its target is met.
class BoostDijkstra {
 public:
  BoostDijkstra(const Digraph& graph, const std::vector<Millis>& costs);
  ~BoostDijkstra();
  Millis cost(VertexId from, VertexId to);

 private:
  struct Graph;
  std::unique_ptr<Graph> graph_;
};

}  // namespace thalweg::bench
