// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "cch/order.hpp"

namespace thalweg {

/// The chordal completion of a graph along an elimination order: what of a customizable contraction hierarchy
/// (Dibbelt, Strasser, Wagner 2016) does not depend on the costs. Ranks number the vertices; an edge joins a
/// lower and a higher rank and carries, in a metric, one cost for each direction.
class CchTopology {
 public:
  using Rank = std::uint32_t;
  using EdgeIndex = std::uint32_t;

  /// `order` holds every vertex once and is postordered. InputError: more edges than 32 bits can number.
  CchTopology(const Digraph& graph, EliminationOrder order);

  [[nodiscard]] std::size_t vertex_count() const { return order_.size(); }
  [[nodiscard]] std::size_t edge_count() const { return heads_.size(); }
  /// Pairs of edges that rise from the same vertex: the work of a customisation.
  [[nodiscard]] std::uint64_t triangle_count() const { return triangle_count_; }
  [[nodiscard]] const EliminationOrder& order() const { return order_; }
  [[nodiscard]] Rank rank(VertexId v) const { return ranks_[v]; }

  /// The edges from `v` to higher ranks are first_edge(v) .. first_edge(v + 1), their heads ascending.
  [[nodiscard]] EdgeIndex first_edge(Rank v) const { return first_[v]; }
  [[nodiscard]] Rank head(EdgeIndex edge) const { return heads_[edge]; }
  /// The same as arrays, for loops that the compiler vectorises.
  [[nodiscard]] const EdgeIndex* first_edges() const { return first_.data(); }
  [[nodiscard]] const Rank* all_heads() const { return heads_.data(); }
  [[nodiscard]] std::span<const Rank> heads(Rank v) const {
    return {heads_.data() + first_[v], heads_.data() + first_[v + 1]};
  }
  /// The edge that joins the two; `no_edge`: they are not joined.
  [[nodiscard]] EdgeIndex edge_between(Rank lower, Rank higher) const;
  static constexpr EdgeIndex no_edge = std::numeric_limits<EdgeIndex>::max();
  /// The elimination tree: the lowest of the higher neighbours; `v` itself at a root.
  [[nodiscard]] Rank parent(Rank v) const { return parents_[v]; }

  /// An edge from a lower rank, as its higher end sees it.
  struct LowerEdge {
    Rank tail;
    EdgeIndex edge;
  };
  [[nodiscard]] std::span<const LowerEdge> lower_edges(Rank v) const {
    return {lower_.data() + lower_first_[v], lower_.data() + lower_first_[v + 1]};
  }

  /// The elimination tree in pieces: whole subtrees that do not take more than a thirtieth of all triangles,
  /// and above them the paths between two forks. What a piece's rows are made of is in them and in the pieces
  /// below. Children before parents.
  [[nodiscard]] std::span<const Rank> piece(std::size_t i) const {  ///< ascending
    return {piece_ranks_.data() + piece_first_[i], piece_ranks_.data() + piece_first_[i + 1]};
  }
  /// By piece: the one above, itself at a root.
  [[nodiscard]] std::span<const std::size_t> piece_parents() const { return piece_parents_; }

  /// Where an arc of the graph goes: the edge, and whether it is driven from its lower to its higher end.
  struct Place {
    ArcId arc;
    EdgeIndex edge;
    bool upward;
  };
  /// Of the edges that rise from first .. last - 1. Arcs from a vertex to itself are of no use to anybody and
  /// left out.
  [[nodiscard]] std::span<const Place> places(Rank first, Rank last) const {
    return {places_.data() + place_first_[first], places_.data() + place_first_[last]};
  }

 private:
  void complete(const Digraph& graph);
  void list_parents();
  void list_lower_edges();
  void cut_pieces();
  void place_arcs(const Digraph& graph);

  EliminationOrder order_;
  IdVector<VertexId, Rank> ranks_;
  std::vector<EdgeIndex> first_;
  std::vector<Rank> heads_;
  std::vector<Rank> parents_;
  std::vector<EdgeIndex> lower_first_;
  std::vector<LowerEdge> lower_;
  std::vector<std::size_t> piece_parents_;
  std::vector<std::size_t> piece_first_;
  std::vector<Rank> piece_ranks_;
  std::vector<std::size_t> place_first_;
  std::vector<Place> places_;
  std::uint64_t triangle_count_ = 0;
};

/// Edges that rise from a vertex and its ancestors in the elimination tree: mean over all vertices. What a
/// search for one cost looks at from each end.
double mean_climb(const CchTopology& topology);

}  // namespace thalweg
