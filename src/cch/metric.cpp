// SPDX-License-Identifier: Apache-2.0
#include "cch/metric.hpp"

#include <algorithm>
#include <atomic>

#include "core/parallel.hpp"

namespace thalweg {

/// The edges that rise from ranks first .. last - 1, as if there were no lower vertices.
template <CchWeight W>
void CchMetric<W>::take_costs(const CchTopology& topology, const std::vector<Millis>& costs,
                              CchTopology::Rank first, CchTopology::Rank last) {
  constexpr W none = cch_infinity<W>;
  const std::size_t edge = topology.first_edge(first);
  const std::size_t count = topology.first_edge(last) - edge;
  std::fill_n(up.data() + edge, count, none);
  std::fill_n(down.data() + edge, count, none);
  std::fill_n(over_.data() + 2 * edge, 2 * count, unknown);
  for (const auto& place : topology.places(first, last)) {
    const Millis cost = costs[place.arc.value];
    if (cost >= infinity || static_cast<std::uint64_t>(cost) >= none) continue;
    W& own = place.upward ? up[place.edge] : down[place.edge];
    own = std::min(own, static_cast<W>(cost));
  }
}

/// Lower triangles: the ways x -> v -> y and y -> v -> x over every lower neighbour v of x and y > x. Writes
/// to the edges of x only; those of v must be done.
template <CchWeight W>
void CchMetric<W>::relax_row(const CchTopology& topology, CchTopology::Rank x, Slots& slots) {
  constexpr W none = cch_infinity<W>;
  for (auto edge = topology.first_edge(x); edge < topology.first_edge(x + 1); ++edge) {
    slots[topology.head(edge)] = edge;
  }
  for (const auto [v, lower] : topology.lower_edges(x)) {
    const W to_v = down[lower];
    const W from_v = up[lower];
    if (to_v >= none && from_v >= none) continue;
    // The higher neighbours of v above x are neighbours of x.
    const auto last = topology.first_edge(v + 1);
    for (auto other = lower + 1; other < last; ++other) {
      const auto edge = slots[topology.head(other)];
      up[edge] = std::min<W>(up[edge], to_v + up[other]);
      down[edge] = std::min<W>(down[edge], down[other] + from_v);
    }
  }
}

template <CchWeight W>
void CchMetric<W>::customise(const CchTopology& topology, const std::vector<Millis>& costs,
                             std::size_t threads) {
  up.resize(topology.edge_count());
  down.resize(topology.edge_count());
  over_.resize(2 * topology.edge_count());
  slots_.resize(std::max<std::size_t>(threads, 1));
  for (Slots& slots : slots_) slots.resize(topology.vertex_count());
  parallel_tree(topology.piece_parents(), threads, [&](std::size_t piece, std::size_t worker) {
    const auto ranks = topology.piece(piece);
    for (std::size_t i = 0; i < ranks.size();) {  // those in a row together: a subtree is one such range
      std::size_t end = i + 1;
      while (end < ranks.size() && ranks[end] == ranks[end - 1] + 1) ++end;
      take_costs(topology, costs, ranks[i], ranks[end - 1] + 1);
      i = end;
    }
    for (const CchTopology::Rank x : ranks) relax_row(topology, x, slots_[worker]);
  });
}

template <CchWeight W>
typename CchMetric<W>::Over CchMetric<W>::over(const Digraph& graph, const std::vector<Millis>& costs,
                                               const CchTopology& topology, const Step& step) const {
  if (topology.lower_edges(step.lower).empty()) return an_arc;
  // Whoever finds it first finds the same.
  const std::atomic_ref<Over> kept(over_[2 * std::size_t{step.edge} + (step.upward ? 1 : 0)]);
  Over known = kept.load(std::memory_order_relaxed);
  if (known == unknown) {
    known = find_over(graph, costs, topology, step);
    kept.store(known, std::memory_order_relaxed);
  }
  return known;
}

/// By the lower triangles, and the arcs from end to end.
template <CchWeight W>
typename CchMetric<W>::Over CchMetric<W>::find_over(const Digraph& graph, const std::vector<Millis>& costs,
                                                    const CchTopology& topology, const Step& step) const {
  const CchTopology::Rank higher = topology.head(step.edge);
  const W cost = (step.upward ? up : down)[step.edge];
  const auto& to_lower = step.upward ? down : up;  // the half between the lowest vertex and the lower end
  const auto& to_higher = step.upward ? up : down;
  Over found = an_arc;
  // Both ends' lower neighbours, ascending; the higher end has the lower one among its own.
  const auto near = topology.lower_edges(step.lower);
  const auto all_far = topology.lower_edges(higher);
  auto far = std::lower_bound(all_far.begin(), all_far.end(), near.front().tail,
                              [](const auto& edge, CchTopology::Rank rank) { return edge.tail < rank; });
  for (const auto [v, edge] : near) {
    while (far->tail < v) ++far;
    if (far->tail != v || to_lower[edge] + to_higher[far->edge] != cost) continue;
    if (found != an_arc) return several;
    found = v;
  }
  if (found == an_arc) return an_arc;
  const VertexId tail = topology.order()[step.upward ? step.lower : higher];
  const VertexId head = topology.order()[step.upward ? higher : step.lower];
  const auto arcs = graph.out(tail);
  const bool is_arc_too = std::any_of(arcs.begin(), arcs.end(), [&](const Arc& arc) {
    return arc.end == head && static_cast<std::uint64_t>(costs[arc.id.value]) == cost;
  });
  return is_arc_too ? several : found;
}

template class CchMetric<std::uint32_t>;
template class CchMetric<std::uint64_t>;

}  // namespace thalweg
