// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/time.hpp"
#include "graph/digraph.hpp"
#include "search/regions.hpp"
#include "search/tree.hpp"

namespace thalweg {

/// Which of its candidates a vertex takes ("alter the operation sign").
enum class Criterion : std::uint8_t { minimum, maximum };

namespace detail {

/// Nothing here branches on what a candidate costs, which nobody can predict: a third of the time on a grid.
template <Direction direction, Criterion criterion, ArcCost C>
void walk_regions(const Digraph& graph, const Regions& regions, const C& cost, Tree& out) {
  constexpr bool minimum = criterion == Criterion::minimum;
  for (std::size_t i = regions.first[1]; i < regions.order.size(); ++i) {
    const VertexId u = regions.order[i];
    const std::uint32_t fore = regions.number[u] - 1;
    Millis best = minimum ? infinity : -1;
    ArcId parent;
    for (const Arc& arc : graph.reaching<direction>(u)) {          // ascending: of equals the lowest id stays
      const Millis candidate = out.label[arc.end] + cost(arc.id);  // two infinities do not overflow
      const bool better = minimum ? candidate < best : (candidate < infinity) & (candidate > best);
      const bool taken = (regions.number[arc.end] == fore) & better;
      best = taken ? candidate : best;
      parent = taken ? arc.id : parent;
    }
    out.label[u] = best < 0 ? infinity : best;
    out.parent[u] = parent;
  }
}

}  // namespace detail

/// The paper's hybrid algorithm (Table 3), in O(V + E): the best (or worst) of the fewest-arc paths from the
/// sources of `regions` to each of their vertices. Of equal candidates the arc with the lowest id wins.
/// Vertices in no region, and those whose every fewest-arc path has a closed arc, keep infinity.
///
/// `regions` must be `partition<direction>` of the same graph. The paper asks for T[x] < T[u]; since T[u] is
/// at most T[x] + 1 that is T[x] = T[u] - 1 for every x that has a region, and, unlike the printed test, it
/// does not admit an x that has none (T[x] = 0), as there are where not every arc has its reverse.
template <Direction direction, ArcCost C>
void hybrid(const Digraph& graph, const Regions& regions, const C& cost, Tree& out,
            Criterion criterion = Criterion::minimum) {
  out.reset(graph.vertex_count());
  if (regions.count() == 0) return;
  for (const VertexId source : regions.region(1)) out.label[source] = 0;
  if (criterion == Criterion::minimum) {
    detail::walk_regions<direction, Criterion::minimum>(graph, regions, cost, out);
  } else {
    detail::walk_regions<direction, Criterion::maximum>(graph, regions, cost, out);
  }
}

}  // namespace thalweg
