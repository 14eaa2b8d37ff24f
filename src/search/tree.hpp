// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cassert>
#include <concepts>
#include <optional>
#include <vector>

#include "core/id.hpp"
#include "core/time.hpp"
#include "graph/digraph.hpp"

namespace thalweg {

/// What an arc costs: a callable (ArcId) -> Millis, never negative. Infinity closes the arc.
template <class C>
concept ArcCost = requires(const C& cost, ArcId arc) {
  { cost(arc) } -> std::convertible_to<Millis>;
};

/// What a search leaves behind: the paper's arrays Sigma (label) and P (parent), indexed by vertex.
/// A forward tree is rooted at the sources of its paths, a backward tree at their destinations.
struct Tree {
  IdVector<VertexId, Millis> label;  ///< cost between the roots and the vertex; infinity: not reached
  IdVector<VertexId, ArcId>
      parent;  ///< the arc next to the vertex on its path; invalid at roots and unreached

  /// Nothing reached. Storage is kept.
  void reset(std::size_t vertices) {
    label.assign(vertices, infinity);
    parent.assign(vertices, ArcId{});
  }
};

/// The end of an arc that lies nearer to the root of a tree in this direction.
template <Direction direction>
[[nodiscard]] VertexId root_end(const ArcEnds& ends) {
  if constexpr (direction == Direction::forward) return ends.tail;
  return ends.head;
}

/// The tree's path between a root and `vertex`, as arcs in driving order: from the root to the vertex in a
/// forward tree, from the vertex to the root in a backward one. Empty at a root; nullopt where unreached.
template <Direction direction>
[[nodiscard]] std::optional<std::vector<ArcId>> path(const Digraph& graph, const Tree& tree,
                                                     VertexId vertex) {
  if (tree.label[vertex] >= infinity) return std::nullopt;
  std::vector<ArcId> arcs;
  for (ArcId arc = tree.parent[vertex]; arc.valid(); arc = tree.parent[vertex]) {
    assert(arcs.size() < graph.vertex_count());  // otherwise the parents form a cycle
    arcs.push_back(arc);
    vertex = root_end<direction>(graph.ends(arc));
  }
  if constexpr (direction == Direction::forward) std::reverse(arcs.begin(), arcs.end());
  return arcs;
}

}  // namespace thalweg
