// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cassert>
#include <vector>

#include "core/time.hpp"
#include "graph/digraph.hpp"

namespace thalweg {

/// Walks from `from` to `to` along arcs that lose as much as they cost: `label(v)` is the exact cost from v
/// to `to`. Arcs of no cost are the only ones that could lead in a circle; a plateau of them is crossed by a
/// breadth-first search to the nearest vertex that has a way down. The vertices after `from` are added to
/// `roads`. Precondition: label(from) < infinity. Ties fall to the first arc of a vertex.
template <class Label>
void walk_next_hops(const Digraph& graph, const std::vector<Millis>& costs, VertexId from, VertexId to,
                    const Label& label, std::vector<VertexId>& roads) {
  struct Step {
    VertexId vertex;
    std::size_t from;  ///< index of the step that led here
  };
  std::vector<Step> plateau;
  VertexId at = from;
  while (at != to) {
    plateau.assign(1, {.vertex = at, .from = 0});
    VertexId down;
    std::size_t reached = 0;
    for (std::size_t i = 0; i < plateau.size() && !down.valid(); ++i) {
      reached = i;
      if (plateau[i].vertex == to) break;
      const Millis height = label(plateau[i].vertex);
      for (const Arc& arc : graph.out(plateau[i].vertex)) {
        const Millis cost = costs[arc.id.value];
        if (cost > height || label(arc.end) != height - cost) continue;
        if (cost > 0) {
          down = arc.end;
          break;
        }
        const bool known = std::any_of(plateau.begin(), plateau.end(),
                                       [&](const Step& step) { return step.vertex == arc.end; });
        if (!known) plateau.push_back({.vertex = arc.end, .from = i});
      }
    }
    const std::size_t end = roads.size();
    for (std::size_t i = reached; i != 0; i = plateau[i].from) roads.push_back(plateau[i].vertex);
    std::reverse(roads.begin() + static_cast<std::ptrdiff_t>(end), roads.end());
    at = plateau[reached].vertex;
    if (at == to) return;
    assert(down.valid());  // labels are exact: some arc is tight
    roads.push_back(down);
    at = down;
  }
}

}  // namespace thalweg
