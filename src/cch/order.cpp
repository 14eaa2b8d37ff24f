// SPDX-License-Identifier: Apache-2.0
#include "cch/order.hpp"

#include <metis.h>

#include <algorithm>
#include <array>
#include <limits>

#include "core/error.hpp"

namespace thalweg {
namespace {

/// Rows of neighbours in either direction, without loops and doubles.
struct Neighbours {
  std::vector<idx_t> first{0};
  std::vector<idx_t> ends;
};

Neighbours neighbours_of(const Digraph& graph) {
  Neighbours rows;
  std::vector<idx_t> row;
  for (std::size_t v = 0; v < graph.vertex_count(); ++v) {
    row.clear();
    for (const Arc& arc : graph.out(VertexId{v})) row.push_back(static_cast<idx_t>(arc.end.value));
    for (const Arc& arc : graph.in(VertexId{v})) row.push_back(static_cast<idx_t>(arc.end.value));
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    for (const idx_t end : row) {
      if (end != static_cast<idx_t>(v)) rows.ends.push_back(end);
    }
    rows.first.push_back(static_cast<idx_t>(rows.ends.size()));
  }
  return rows;
}

using Rank = std::uint32_t;
constexpr Rank no_rank = std::numeric_limits<Rank>::max();

/// Liu's elimination tree, without the fill: the parent of every rank, `no_rank` at roots.
std::vector<Rank> elimination_tree(const Digraph& graph, const EliminationOrder& order) {
  IdVector<VertexId, Rank> ranks(order.size());
  for (Rank r = 0; r < order.size(); ++r) ranks[order[r]] = r;
  std::vector<Rank> parent(order.size(), no_rank);
  std::vector<Rank> ancestor(order.size(), no_rank);  // short cuts towards the root
  for (Rank v = 0; v < order.size(); ++v) {
    const auto join = [&](const Arc& arc) {
      Rank below = ranks[arc.end];
      while (below < v) {
        const Rank next = ancestor[below];
        ancestor[below] = v;
        if (next == no_rank) parent[below] = v;
        if (next == no_rank || next == v) break;
        below = next;
      }
    };
    for (const Arc& arc : graph.out(order[v])) join(arc);
    for (const Arc& arc : graph.in(order[v])) join(arc);
  }
  return parent;
}

}  // namespace

EliminationOrder postordered(const Digraph& graph, const EliminationOrder& order) {
  const std::vector<Rank> parent = elimination_tree(graph, order);
  // Lists of children, linked; the highest child is entered first so that the lowest comes out first.
  std::vector<Rank> child(order.size(), no_rank);
  std::vector<Rank> sibling(order.size(), no_rank);
  Rank root = no_rank;
  for (auto v = static_cast<Rank>(order.size()); v-- > 0;) {
    Rank& first = parent[v] == no_rank ? root : child[parent[v]];
    sibling[v] = first;
    first = v;
  }
  EliminationOrder result;
  result.reserve(order.size());
  std::vector<Rank> open;
  for (; root != no_rank; root = sibling[root]) {
    open.push_back(root);
    while (!open.empty()) {
      const Rank v = open.back();
      if (child[v] == no_rank) {
        result.push_back(order[v]);
        open.pop_back();
      } else {
        open.push_back(child[v]);
        child[v] = sibling[child[v]];
      }
    }
  }
  return result;
}

EliminationOrder nested_dissection(const Digraph& graph) {
  EliminationOrder order(graph.vertex_count());
  Neighbours rows = neighbours_of(graph);
  if (rows.ends.empty()) {  // nothing to dissect, which METIS does not accept
    for (std::size_t v = 0; v < order.size(); ++v) order[v] = VertexId{v};
    return order;
  }
  verify(rows.ends.size() < static_cast<std::size_t>(std::numeric_limits<idx_t>::max()),
         "the network is too large for METIS");
  auto count = static_cast<idx_t>(graph.vertex_count());
  std::vector<idx_t> vertex_of_rank(order.size());
  std::vector<idx_t> rank_of_vertex(order.size());
  std::array<idx_t, METIS_NOPTIONS> options{};
  METIS_SetDefaultOptions(options.data());
  options[METIS_OPTION_SEED] = 1;
  verify(METIS_NodeND(&count, rows.first.data(), rows.ends.data(), nullptr, options.data(),
                      vertex_of_rank.data(), rank_of_vertex.data()) == METIS_OK,
         "METIS found no order of the network (out of memory?)");
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    order[rank] = VertexId{static_cast<std::size_t>(vertex_of_rank[rank])};
  }
  return postordered(graph, order);
}

}  // namespace thalweg
