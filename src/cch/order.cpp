// SPDX-License-Identifier: Apache-2.0
#include "cch/order.hpp"

#include <metis.h>

#include <algorithm>

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

}  // namespace

EliminationOrder nested_dissection(const Digraph& graph) {
  auto count = static_cast<idx_t>(graph.vertex_count());
  EliminationOrder order(graph.vertex_count());
  if (count == 0) return order;
  Neighbours rows = neighbours_of(graph);
  std::vector<idx_t> vertex_of_rank(order.size());
  std::vector<idx_t> rank_of_vertex(order.size());
  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 1;
  if (METIS_NodeND(&count, rows.first.data(), rows.ends.data(), nullptr, options, vertex_of_rank.data(),
                   rank_of_vertex.data()) != METIS_OK) {
    throw InputError("METIS found no order of the network (out of memory?)");
  }
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    order[rank] = VertexId{static_cast<std::size_t>(vertex_of_rank[rank])};
  }
  return order;
}

}  // namespace thalweg
