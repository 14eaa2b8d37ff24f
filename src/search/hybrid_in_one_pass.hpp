// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "core/time.hpp"
#include "graph/digraph.hpp"
#include "search/regions.hpp"
#include "search/tree.hpp"

namespace thalweg {

/// Regions and best fewest-arc paths of one search. What a search asks about a vertex lies together: on a
/// grid of 4 million vertices that was about a sixth faster than an array each (docs/paper.md).
struct MarkedRegions {
  struct Mark {
    Millis label = infinity;   ///< as in Tree
    ArcId parent;              ///< as in Tree
    std::uint32_t number = 0;  ///< as in Regions
  };
  IdVector<VertexId, Mark> marks;
  std::vector<VertexId> order;       ///< as in Regions
  std::vector<std::uint32_t> first;  ///< as in Regions
};

/// `partition` and `hybrid` (minimum) at once, with the same result to the last parent: all labels of a
/// region are final once the region before it has been left, so they can be offered to the next region while
/// that is found. The arcs are read once, in the order in which the search leaves its vertices, instead of
/// twice.
template <Direction direction, ArcCost C>
void partition_and_hybrid(const Digraph& graph, std::span<const VertexId> sources, const C& cost,
                          MarkedRegions& out) {
  const std::size_t count = graph.vertex_count();
  auto& marks = out.marks;
  auto& order = out.order;
  marks.assign(count, {});
  order.resize(count);
  out.first.assign(1, 0);
  std::uint32_t size = 0;
  for (const VertexId source : sources) {
    if (marks[source].number != 0) continue;
    marks[source] = {.label = 0, .parent = {}, .number = 1};
    order[size++] = source;
  }
  for (std::uint32_t i = 0; i < size;) {
    const std::uint32_t end = size;
    out.first.push_back(end);
    const auto next = static_cast<std::uint32_t>(out.first.size());
    for (; i < end; ++i) {
      const VertexId u = order[i];
      const Millis label = marks[u].label;
      for (const Arc& arc : graph.leaving<direction>(u)) {
        auto& mark = marks[arc.end];
        if (mark.number != 0 && mark.number != next) continue;
        const Millis candidate = label + cost(arc.id);  // two infinities do not overflow
        const bool open = candidate < infinity;
        if (mark.number == 0) {
          mark = {.label = open ? candidate : infinity, .parent = open ? arc.id : ArcId{}, .number = next};
          order[size++] = arc.end;
        } else if (candidate < mark.label || (candidate == mark.label && open && arc.id < mark.parent)) {
          mark.label = candidate;  // of equals the lowest arc
          mark.parent = arc.id;
        }
      }
    }
  }
  order.resize(size);
}

}  // namespace thalweg
