// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/time.hpp"
#include "graph/digraph.hpp"

namespace thalweg::lab {

/// Boost.Graph's Dijkstra over Boost's own compressed rows: what the runtime experiment and the benchmarks
/// are held against. Nothing else uses it.
class BoostDijkstra {
 public:
  BoostDijkstra(const Digraph& graph, std::span<const std::int32_t> costs);
  BoostDijkstra(const BoostDijkstra&) = delete;
  BoostDijkstra& operator=(const BoostDijkstra&) = delete;
  ~BoostDijkstra();

  void run(VertexId source);
  /// Ends when `target` is met. Its label; the greatest Millis: it is out of reach.
  Millis run(VertexId source, VertexId target);
  /// Of all vertices, from the last whole run; unreached ones have the greatest Millis.
  [[nodiscard]] const std::vector<Millis>& labels() const;

 private:
  struct Graph;
  std::unique_ptr<Graph> graph_;
};

}  // namespace thalweg::lab
