// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cassert>
#include <span>
#include <vector>

#include "core/time.hpp"
#include "graph/digraph.hpp"
#include "search/tree.hpp"

namespace thalweg {

/// Storage of `dijkstra`, to be reused; one a thread.
struct DijkstraScratch {
  struct Entry {
    Millis label;
    VertexId vertex;
    /// The other way round: the standard's heaps keep the greatest on top.
    friend bool operator<(const Entry& a, const Entry& b) {
      return a.label != b.label ? a.label > b.label : a.vertex.value > b.vertex.value;
    }
  };
  std::vector<Entry> heap;
};

/// The tree of least cost from `sources` to every vertex. Binary heap, lazy deletion; of equal labels the
/// lowest vertex is settled first, and of equal paths to a vertex the one found first stays.
///
/// With `targets` it stops once all of them are settled (if one is out of reach: at the end). The labels and
/// parents of settled vertices are right; the labels of others, which are never below those of settled ones,
/// may then be upper bounds only.
template <Direction direction, ArcCost C>
void dijkstra(const Digraph& graph, std::span<const VertexId> sources, const C& cost, Tree& out,
              DijkstraScratch& scratch, std::span<const VertexId> targets = {}) {
  out.reset(graph.vertex_count());
  auto& heap = scratch.heap;
  heap.clear();
  const auto reach = [&](VertexId v, Millis label, ArcId parent) {
    if (label >= out.label[v]) return;
    out.label[v] = label;
    out.parent[v] = parent;
    heap.push_back({.label = label, .vertex = v});
    std::push_heap(heap.begin(), heap.end());
  };
  for (const VertexId source : sources) reach(source, 0, ArcId{});

  std::size_t met = 0;  // targets[0 .. met) are settled
  while (!heap.empty()) {
    std::pop_heap(heap.begin(), heap.end());
    const auto [label, u] = heap.back();
    heap.pop_back();
    if (label > out.label[u]) continue;  // a cheaper entry came first
    // Costs are >= 0: nothing lowers a label that is not above the one just taken.
    while (met < targets.size() && out.label[targets[met]] <= label) ++met;
    if (!targets.empty() && met == targets.size()) return;
    for (const Arc& arc : graph.leaving<direction>(u)) {
      assert(cost(arc.id) >= 0);
      reach(arc.end, add_saturating(label, cost(arc.id)), arc.id);
    }
  }
}

}  // namespace thalweg
