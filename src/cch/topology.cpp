// SPDX-License-Identifier: Apache-2.0
#include "cch/topology.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/error.hpp"

namespace thalweg {

CchTopology::CchTopology(const Digraph& graph, EliminationOrder order)
    : order_(std::move(order)), ranks_(graph.vertex_count()) {
  assert(order_.size() == graph.vertex_count());
  for (Rank r = 0; r < order_.size(); ++r) ranks_[order_[r]] = r;
  complete(graph);
  list_parents();
  list_lower_edges();
  cut_subtrees();
  place_arcs(graph);
}

void CchTopology::complete(const Digraph& graph) {
  // Each vertex hands its higher neighbours to the lowest of them: with these that one has all it will ever
  // have once its turn comes (the fill of a sparse Cholesky factor, row by row).
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
    verify(heads_.size() + row.size() < std::numeric_limits<EdgeIndex>::max(),
           "the network fills in too much for a contraction hierarchy");
    heads_.insert(heads_.end(), row.begin(), row.end());
    first_.push_back(static_cast<EdgeIndex>(heads_.size()));
    if (row.size() > 1) {
      auto& parents = pending[row.front()];
      parents.insert(parents.end(), row.begin() + 1, row.end());
      triangle_count_ += static_cast<std::uint64_t>(row.size()) * (row.size() - 1) / 2;
    }
  }
}

CchTopology::EdgeIndex CchTopology::edge_between(Rank lower, Rank higher) const {
  const auto row = heads(lower);
  const auto found = std::lower_bound(row.begin(), row.end(), higher);
  if (found == row.end() || *found != higher) return no_edge;
  return first_[lower] + static_cast<EdgeIndex>(found - row.begin());
}

void CchTopology::list_parents() {
  parents_.resize(vertex_count());
  for (Rank v = 0; v < vertex_count(); ++v) parents_[v] = first_[v] == first_[v + 1] ? v : heads_[first_[v]];
}

void CchTopology::list_lower_edges() {
  lower_first_.assign(order_.size() + 1, 0);
  for (const Rank head : heads_) ++lower_first_[head + 1];
  for (std::size_t v = 0; v < order_.size(); ++v) lower_first_[v + 1] += lower_first_[v];
  lower_.resize(heads_.size());
  std::vector<EdgeIndex> next(lower_first_.begin(), lower_first_.end() - 1);
  for (Rank v = 0; v < order_.size(); ++v) {
    for (EdgeIndex edge = first_[v]; edge < first_[v + 1]; ++edge) {
      lower_[next[heads_[edge]]++] = {.tail = v, .edge = edge};
    }
  }
}

void CchTopology::cut_subtrees() {
  std::vector<std::uint64_t> work(order_.size(),
                                  0);  // triangles of the whole subtree; a vertex counts as one
  std::vector<Rank> size(order_.size(), 1);
  const std::uint64_t limit = (triangle_count_ + order_.size()) / 100;
  for (Rank v = 0; v < order_.size(); ++v) {
    const std::uint64_t row = heads(v).size();
    work[v] += 1 + row * (row > 0 ? row - 1 : 0) / 2;
    if (parent(v) == v) continue;
    work[parent(v)] += work[v];
    size[parent(v)] += size[v];
  }
  for (Rank v = 0; v < order_.size(); ++v) {
    const bool whole = work[v] <= limit;
    const bool parent_too = parent(v) != v && work[parent(v)] <= limit;
    if (whole && !parent_too) subtrees_.push_back({.first = v + 1 - size[v], .last = v + 1});
  }
}

void CchTopology::place_arcs(const Digraph& graph) {
  places_.reserve(graph.arc_count());
  for (std::size_t i = 0; i < graph.arc_count(); ++i) {
    const ArcEnds& ends = graph.ends(ArcId{i});
    const Rank tail = ranks_[ends.tail];
    const Rank head = ranks_[ends.head];
    if (tail == head) {
      places_.push_back({.edge = 0, .upward = false, .is_loop = true});
      continue;
    }
    places_.push_back({.edge = edge_between(std::min(tail, head), std::max(tail, head)),
                       .upward = tail < head,
                       .is_loop = false});
  }
}

double mean_climb(const CchTopology& topology) {
  std::vector<double> climb(topology.vertex_count());
  double sum = 0;
  for (std::size_t v = climb.size(); v-- > 0;) {
    const auto rank = static_cast<CchTopology::Rank>(v);
    const auto parent = topology.parent(rank);
    climb[v] = static_cast<double>(topology.heads(rank).size()) + (parent == rank ? 0 : climb[parent]);
    sum += climb[v];
  }
  return sum / std::max(1.0, static_cast<double>(climb.size()));
}

}  // namespace thalweg
