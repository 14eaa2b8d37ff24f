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
  Millis height = label(from);
  while (at != to) {
    plateau.assign(1, {.vertex = at, .from = 0});
    Arc down;
    std::size_t reached = 0;
    for (std::size_t i = 0; i < plateau.size() && !down.end.valid(); ++i) {
      reached = i;
      if (plateau[i].vertex == to) break;
      const auto arcs = graph.out(plateau[i].vertex);
      const auto possible = [&](const Arc& arc) { return costs[arc.id.value] <= height; };
      std::size_t left = static_cast<std::size_t>(std::count_if(arcs.begin(), arcs.end(), possible));
      bool is_known_way = false;
      for (const Arc& arc : arcs) {
        if (!possible(arc)) continue;
        const Millis cost = costs[arc.id.value];
        // Labels are exact: some arc is tight, so the last needs no look when none before it was.
        const bool is_tight = (--left == 0 && !is_known_way) || label(arc.end) == height - cost;
        if (!is_tight) continue;
        if (cost > 0) {
          down = arc;
          break;
        }
        is_known_way = true;
        const bool known = std::any_of(plateau.begin(), plateau.end(),
                                       [&](const Step& step) { return step.vertex == arc.end; });
        if (!known) plateau.push_back({.vertex = arc.end, .from = i});
      }
    }
    const std::size_t end = roads.size();
    for (std::size_t i = reached; i != 0; i = plateau[i].from) roads.push_back(plateau[i].vertex);
    std::reverse(roads.begin() + static_cast<std::ptrdiff_t>(end), roads.end());
    if (plateau[reached].vertex == to) return;
    assert(down.end.valid());
    at = down.end;
    height -= costs[down.id.value];
    roads.push_back(at);
  }
}

}  // namespace thalweg
