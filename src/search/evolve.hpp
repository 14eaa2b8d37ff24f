// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/time.hpp"
#include "graph/digraph.hpp"
#include "search/regions.hpp"
#include "search/tree.hpp"

namespace thalweg {

struct EvolutionLimit {
  std::uint32_t max_rounds = 0;  ///< 0: the number of vertices, which always suffices for costs >= 0
};

struct Evolution {
  std::uint32_t rounds = 0;   ///< rounds run; one that finds nothing to change counts too
  std::uint64_t changes = 0;  ///< labels lowered
  bool settled = true;        ///< false: max_rounds were not enough
};

/// Storage of `evolve`, to be reused; one a thread.
struct EvolveScratch {
  std::vector<VertexId> frontier;
  std::vector<VertexId> next;
  IdVector<VertexId, std::uint8_t> queued;  ///< 1: awaits its turn in this round or the next
};

namespace detail {

/// From this many vertices on, ordering a round costs less than it saves.
inline constexpr std::size_t worth_ordering = 1'000;

/// Puts the vertices of `frontier` whose label is below `bound` roughly in the order of their labels
/// (counting sort by the leading bits of the label; equal ones keep their order) and drops the others, which
/// leave the queue. A round goes over its vertices in any order that it likes; in this one it lowers most
/// labels once.
inline void order_frontier(const Tree& tree, Millis bound, EvolveScratch& scratch) {
  auto& [frontier, ordered, queued] = scratch;
  Millis least = infinity;
  Millis greatest = 0;
  for (const VertexId v : frontier) {
    const Millis label = tree.label[v];
    if (label >= bound) continue;
    least = std::min(least, label);
    greatest = std::max(greatest, label);
  }
  constexpr int key_bits = 10;
  const auto range = static_cast<std::uint64_t>(std::max<Millis>(0, greatest - least));
  const int shift = std::max(0, static_cast<int>(std::bit_width(range)) - key_bits);
  const auto key = [&](VertexId v) { return static_cast<std::size_t>((tree.label[v] - least) >> shift); };
  std::array<std::uint32_t, (1U << key_bits) + 1> first{};
  for (const VertexId v : frontier) {
    if (tree.label[v] < bound) ++first[key(v) + 1];
  }
  for (std::size_t k = 1; k < first.size(); ++k) first[k] += first[k - 1];
  ordered.resize(first.back());
  for (const VertexId v : frontier) {
    if (tree.label[v] < bound) {
      ordered[first[key(v)]++] = v;
    } else {
      queued[v] = 0;
    }
  }
  std::swap(frontier, ordered);
}

}  // namespace detail

/// The paper's evolutionary hybrid: Sigma[u] = min over all x in beta(u) of Sigma[x] + w(x, u), until nothing
/// changes. `tree` is what `hybrid<direction>` made of `regions` and the same costs; it ends as the tree of
/// least cost. Rounds work in place: the first looks at all of `regions.order`, each later one at the
/// vertices whose label fell since their last turn.
///
/// With `targets` it stops earlier: the labels and paths of the targets, and of every vertex cheaper than the
/// dearest of them, are those of least cost; other labels are upper bounds whose paths cost no more than
/// they. Not settled: all labels are such upper bounds.
///
/// Why the parents stay acyclic: a parent changes only on strict improvement, and label[v] >= label[parent] +
/// cost holds throughout. Were a change to close a cycle, the sum of these inequalities around it, one of
/// them strict, would make its cost negative.
///
/// Why cutting at the bound is exact: the bound is the greatest label of the targets at the start of a round,
/// so never below their final greatest label B. Let, at the end, label[t] > dist[t] and dist[t] < B for
/// some t, or t be a target (dist[t] < label[t] <= B). On a least-cost path to t let v be the first vertex
/// with label[v] > dist[v], and x its predecessor: label[x] = dist[x] since x's last turn, where the
/// candidate dist[v] was not taken. So it was cut: dist[v] >= bound >= B > dist[t], against costs >= 0.
/// Candidates equal to the bound may be cut because they improve no target strictly. The parents of exact t:
/// label[t] >= label[p] + cost >= dist[p] + cost >= dist[t] = label[t], so p is exact, and so on to the root.
template <Direction direction, ArcCost C>
Evolution evolve(const Digraph& graph, const Regions& regions, const C& cost, Tree& tree,
                 EvolveScratch& scratch, EvolutionLimit limit = {}, std::span<const VertexId> targets = {}) {
  const std::uint32_t max_rounds =
      limit.max_rounds != 0 ? limit.max_rounds : static_cast<std::uint32_t>(graph.vertex_count());
  auto& [frontier, next, queued] = scratch;
  frontier.assign(regions.order.begin(), regions.order.end());
  queued.assign(graph.vertex_count(), 0);
  for (const VertexId v : frontier) queued[v] = 1;

  Evolution result;
  for (; !frontier.empty() && result.rounds < max_rounds; ++result.rounds) {
    Millis bound = targets.empty() ? infinity : 0;
    for (const VertexId target : targets) bound = std::max(bound, tree.label[target]);
    if (frontier.size() >= detail::worth_ordering) detail::order_frontier(tree, bound, scratch);
    next.clear();
    for (const VertexId u : frontier) {
      queued[u] = 0;
      const Millis label = tree.label[u];
      if (label >= bound) continue;
      for (const Arc& arc : graph.leaving<direction>(u)) {
        assert(cost(arc.id) >= 0);
        const Millis candidate = add_saturating(label, cost(arc.id));
        if (candidate >= bound || candidate >= tree.label[arc.end]) continue;
        tree.label[arc.end] = candidate;
        tree.parent[arc.end] = arc.id;
        ++result.changes;
        if (queued[arc.end] == 0) {
          queued[arc.end] = 1;
          next.push_back(arc.end);
        }
      }
    }
    std::swap(frontier, next);
  }
  result.settled = frontier.empty();
  return result;
}

}  // namespace thalweg
