// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "graph/digraph.hpp"
#include "search/evolve.hpp"
#include "search/hybrid.hpp"
#include "search/tree.hpp"

namespace thalweg {

/// What a vertex sees of the others in a round.
enum class RoundUpdate : std::uint8_t {
  in_place,          ///< labels as they stand, those changed in this round included
  from_former_round  ///< all labels as the round before left them
};

struct RoundOptions {
  RoundUpdate update = RoundUpdate::in_place;
  Criterion criterion = Criterion::minimum;
  EvolutionLimit limit{};             ///< max_rounds 0: the number of vertices
  std::span<const VertexId> order{};  ///< in which a round visits the vertices; empty: by number
};

struct RoundEvolution {
  std::vector<std::uint64_t> changes;  ///< labels changed in each round; the last entry is 0 when settled
  bool settled = false;

  [[nodiscard]] std::uint32_t rounds() const { return static_cast<std::uint32_t>(changes.size()); }
  [[nodiscard]] std::uint64_t total() const {
    return std::accumulate(changes.begin(), changes.end(), std::uint64_t{0});
  }
};

/// The paper's evolutionary hybrid as it stands there: every round visits every vertex, which takes the best
/// of all its in-neighbours when that betters its label, until a round changes nothing. Bellman and Ford's
/// method with hybrid's tree for a start. `search/evolve.hpp` ends in the same labels sooner, because it
/// looks only at what changed; this one exists to count rounds as the paper does, in either way of updating
/// and any order, and to take the other criterion.
///
/// Roots keep their labels. Minimum: for costs >= 0 it settles within max(1, V - 1) rounds (docs/paper.md has
/// the proof) and the tree is the one of least cost. Maximum: a label grows along every cycle that it can go
/// round, so a reachable cycle of positive cost never settles: `settled` is then false, the labels are those
/// of walks, and the parents may form a cycle (`path` must not follow them).
template <Direction direction, ArcCost C>
RoundEvolution evolve_in_rounds(const Digraph& graph, const C& cost, Tree& tree,
                                const RoundOptions& options = {}) {
  const auto vertices = graph.vertex_count();
  const std::uint32_t max_rounds =
      options.limit.max_rounds != 0 ? options.limit.max_rounds : static_cast<std::uint32_t>(vertices);
  IdVector<VertexId, bool> root(vertices, false);
  for (std::size_t i = 0; i < vertices; ++i) {
    const VertexId v{i};
    root[v] = tree.label[v] < infinity && !tree.parent[v].valid();
  }
  const bool in_place = options.update == RoundUpdate::in_place;
  IdVector<VertexId, Millis> former;
  RoundEvolution out;
  while (out.rounds() < max_rounds && !out.settled) {
    if (!in_place) former = tree.label;
    const auto& seen = in_place ? tree.label : former;
    std::uint64_t changes = 0;
    const auto visit = [&](VertexId u) {
      if (root[u]) return;
      Millis best = tree.label[u];
      ArcId parent;
      for (const Arc& arc : graph.reaching<direction>(u)) {
        assert(cost(arc.id) >= 0);
        const Millis candidate = add_saturating(seen[arc.end], cost(arc.id));
        if (candidate >= infinity) continue;
        const bool better =
            options.criterion == Criterion::minimum ? candidate < best : best >= infinity || candidate > best;
        if (!better) continue;
        best = candidate;
        parent = arc.id;
      }
      if (!parent.valid()) return;
      tree.label[u] = best;
      tree.parent[u] = parent;
      ++changes;
    };
    if (options.order.empty()) {
      for (std::size_t i = 0; i < vertices; ++i) visit(VertexId{i});
    } else {
      for (const VertexId v : options.order) visit(v);
    }
    out.changes.push_back(changes);
    out.settled = changes == 0;
  }
  if (vertices == 0) out.settled = true;
  return out;
}

}  // namespace thalweg
