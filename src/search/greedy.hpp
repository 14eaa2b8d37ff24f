// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "graph/digraph.hpp"
#include "search/hybrid.hpp"
#include "search/regions.hpp"
#include "search/tree.hpp"

namespace thalweg {

struct GreedyHybrid {
  std::vector<ArcId> path;  ///< of the whole graph; empty when the target is out of reach
  Millis cost = infinity;
  std::size_t arcs_used = 0;  ///< arcs in the subgraph that was searched
  std::size_t batches = 0;    ///< batches added
};

/// The paper's greedy hybrid: the arcs are added to an empty graph in batches, cheapest first (of equals the
/// lowest id), until a partition from `source` reaches `target`; then hybrid runs on what has been added.
/// `batch` is the number of arcs of a batch; 0 makes one of all arcs of equal cost. Closed arcs stay out.
///
/// Reached vertices are carried from batch to batch, so all partitions together take O(E).
template <ArcCost C>
[[nodiscard]] GreedyHybrid greedy_hybrid(const Digraph& graph, VertexId source, VertexId target,
                                         const C& cost, std::size_t batch = 0) {
  std::vector<ArcId> sorted;
  sorted.reserve(graph.arc_count());
  for (std::size_t i = 0; i < graph.arc_count(); ++i) {
    if (cost(ArcId{i}) < infinity) sorted.emplace_back(i);
  }
  std::stable_sort(sorted.begin(), sorted.end(), [&](ArcId a, ArcId b) { return cost(a) < cost(b); });

  IdVector<VertexId, bool> reached(graph.vertex_count(), false);
  std::vector<bool> added(graph.arc_count(), false);
  std::vector<VertexId> stack;
  const auto reach = [&](VertexId from) {
    stack.push_back(from);
    reached[from] = true;
    while (!stack.empty()) {
      const VertexId u = stack.back();
      stack.pop_back();
      for (const Arc& arc : graph.out(u)) {
        if (!added[arc.id.value] || reached[arc.end]) continue;
        reached[arc.end] = true;
        stack.push_back(arc.end);
      }
    }
  };
  reach(source);
  GreedyHybrid out;
  while (!reached[target] && out.arcs_used < sorted.size()) {
    std::size_t end = batch == 0 ? out.arcs_used : std::min(out.arcs_used + batch, sorted.size());
    if (batch == 0) {
      const Millis level = cost(sorted[end]);
      while (end < sorted.size() && cost(sorted[end]) == level) ++end;
    }
    for (std::size_t i = out.arcs_used; i < end; ++i) {
      added[sorted[i].value] = true;
      const auto [tail, head] = graph.ends(sorted[i]);
      if (reached[tail] && !reached[head]) reach(head);
    }
    out.arcs_used = end;
    ++out.batches;
  }
  if (!reached[target]) return out;

  sorted.resize(out.arcs_used);
  std::sort(sorted.begin(), sorted.end());  // ties in hybrid go to the lowest id, as in the whole graph
  std::vector<ArcEnds> ends;
  ends.reserve(sorted.size());
  for (const ArcId arc : sorted) ends.push_back(graph.ends(arc));
  const Digraph subgraph(graph.vertex_count(), ends);
  Regions regions;
  Tree tree;
  partition<Direction::forward>(subgraph, {&source, 1}, regions, {&target, 1});
  hybrid<Direction::forward>(
      subgraph, regions, [&](ArcId arc) { return cost(sorted[arc.value]); }, tree);
  out.cost = tree.label[target];
  const auto found = path<Direction::forward>(subgraph, tree, target);
  for (const ArcId arc : found.value()) out.path.push_back(sorted[arc.value]);
  return out;
}

}  // namespace thalweg
