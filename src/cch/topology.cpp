// SPDX-License-Identifier: Apache-2.0
#include "cch/topology.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "core/rows.hpp"

namespace thalweg {

CchTopology::CchTopology(const Digraph& graph, EliminationOrder order)
    : order_(std::move(order)), ranks_(graph.vertex_count()) {
  assert(order_.size() == graph.vertex_count());
  for (Rank r = 0; r < order_.size(); ++r) ranks_[order_[r]] = r;
  complete(graph);
  list_parents();
  list_lower_edges();
  cut_pieces();
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
  const auto for_each = [&](const auto& visit) {
    for (Rank v = 0; v < order_.size(); ++v) {
      for (EdgeIndex edge = first_[v]; edge < first_[v + 1]; ++edge)
        visit(heads_[edge], [&] { return LowerEdge{.tail = v, .edge = edge}; });
    }
  };
  fill_rows(order_.size(), for_each, lower_first_, lower_);
}

void CchTopology::cut_pieces() {
  const auto count = static_cast<Rank>(order_.size());
  std::vector<std::uint64_t> work(count, 0);  // triangles of the whole subtree; a vertex counts as one
  const std::uint64_t limit = (triangle_count_ + count) / 30;
  std::vector<Rank> branches(count, 0);  // children above the limit
  for (Rank v = 0; v < count; ++v) {
    const std::uint64_t row = heads(v).size();
    work[v] += 1 + row * (row > 0 ? row - 1 : 0) / 2;
    if (parent(v) == v) continue;
    work[parent(v)] += work[v];
    if (work[v] > limit) ++branches[parent(v)];
  }
  // From the top down: a vertex is in the piece of its parent if that is a subtree, or a path that goes on
  // here.
  std::vector<std::size_t> piece_of(count);
  std::vector<Rank> highest;  // by piece
  for (Rank v = count; v-- > 0;) {
    const Rank above = parent(v);
    const bool is_path = work[v] > limit;
    const bool goes_on = above != v && (is_path ? branches[above] == 1 : work[above] <= limit);
    piece_of[v] = goes_on ? piece_of[above] : highest.size();
    if (!goes_on) highest.push_back(v);
  }
  const std::size_t pieces = highest.size();
  const auto number = [&](Rank v) { return pieces - 1 - piece_of[v]; };  // children before parents
  piece_parents_.resize(pieces);
  for (std::size_t i = 0; i < pieces; ++i) piece_parents_[pieces - 1 - i] = number(parent(highest[i]));
  const auto for_each = [&](const auto& visit) {
    for (Rank v = 0; v < count; ++v) visit(number(v), [&] { return v; });
  };
  fill_rows(pieces, for_each, piece_first_, piece_ranks_);
}

void CchTopology::place_arcs(const Digraph& graph) {
  const auto for_each = [&](const auto& visit) {
    for (std::size_t i = 0; i < graph.arc_count(); ++i) {
      const Rank tail = ranks_[graph.ends(ArcId{i}).tail];
      const Rank head = ranks_[graph.ends(ArcId{i}).head];
      if (tail == head) continue;
      const Rank lower = std::min(tail, head);
      visit(lower, [&] {
        const Rank higher = std::max(tail, head);
        return Place{.arc = ArcId{i}, .edge = edge_between(lower, higher), .upward = tail < head};
      });
    }
  };
  fill_rows(order_.size(), for_each, place_first_, places_);
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
