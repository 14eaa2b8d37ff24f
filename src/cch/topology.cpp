// SPDX-License-Identifier: Apache-2.0
#include "cch/topology.hpp"

#include <algorithm>
#include <utility>

namespace thalweg {

CchTopology::CchTopology(const Digraph& graph, EliminationOrder order)
    : order_(std::move(order)), ranks_(graph.vertex_count()) {
  assert(order_.size() == graph.vertex_count());
  for (Rank r = 0; r < order_.size(); ++r) ranks_[order_[r]] = r;

  // Each vertex hands its higher neighbours to the lowest of them: with these that one has all it will ever have
  // once its turn comes (the fill of a sparse Cholesky factor, row by row).
  std::vector<std::vector<Rank>> pending(order_.size());
  first_.reserve(order_.size() + 1);
  first_.push_back(0);
  std::vector<Rank> row;
  for (Rank v = 0; v < order_.size(); ++v) {
    row = std::move(pending[v]);
    pending[v] = {};
    const auto add = [&](const Arc& arc) {
      if (ranks_[arc.end] > v) row.push_back(ranks_[arc.end]);
    };
    for (const Arc& arc : graph.out(order_[v])) add(arc);
    for (const Arc& arc : graph.in(order_[v])) add(arc);
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    heads_.insert(heads_.end(), row.begin(), row.end());
    first_.push_back(static_cast<EdgeIndex>(heads_.size()));
    if (row.size() > 1) {
      auto& parents = pending[row.front()];
      if (parents.empty()) {
        parents.assign(row.begin() + 1, row.end());
      } else {
        parents.insert(parents.end(), row.begin() + 1, row.end());
      }
    }
  }

  places_.reserve(graph.arc_count());
  for (std::size_t i = 0; i < graph.arc_count(); ++i) {
    const ArcEnds& ends = graph.ends(ArcId{i});
    const Rank tail = ranks_[ends.tail];
    const Rank head = ranks_[ends.head];
    const Rank lower = std::min(tail, head);
    if (tail == head) {
      places_.push_back({.edge = 0, .upward = false, .is_loop = true});
      continue;
    }
    const auto higher = heads(lower);
    const auto found = std::lower_bound(higher.begin(), higher.end(), std::max(tail, head));
    places_.push_back({.edge = first_[lower] + static_cast<EdgeIndex>(found - higher.begin()),
                       .upward = tail < head,
                       .is_loop = false});
  }
}

}  // namespace thalweg
