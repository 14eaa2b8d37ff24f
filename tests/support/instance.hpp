// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <initializer_list>
#include <vector>

#include "core/id.hpp"
#include "core/time.hpp"
#include "graph/digraph.hpp"

namespace thalweg::testing {

/// A graph and what its arcs cost. Usable as an ArcCost.
struct Instance {
  Digraph graph;
  std::vector<Millis> costs;
  Millis operator()(ArcId arc) const { return costs[arc.value]; }
};

struct WeightedArc {
  std::uint32_t tail;
  std::uint32_t head;
  Millis cost = 1;
};

inline Instance make_instance(std::size_t vertices, std::initializer_list<WeightedArc> weighted) {
  std::vector<ArcEnds> arcs;
  std::vector<Millis> costs;
  for (const WeightedArc& arc : weighted) {
    arcs.push_back({.tail = VertexId{arc.tail}, .head = VertexId{arc.head}});
    costs.push_back(arc.cost);
  }
  return {.graph = Digraph(vertices, arcs), .costs = std::move(costs)};
}

inline std::vector<VertexId> vertices(std::initializer_list<std::uint32_t> values) {
  std::vector<VertexId> out;
  for (const std::uint32_t value : values) out.emplace_back(value);
  return out;
}

inline std::vector<ArcId> arcs(std::initializer_list<std::uint32_t> values) {
  std::vector<ArcId> out;
  for (const std::uint32_t value : values) out.emplace_back(value);
  return out;
}

}  // namespace thalweg::testing
