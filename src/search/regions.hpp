// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/id.hpp"
#include "graph/digraph.hpp"

namespace thalweg {

/// The paper's graph partition: region 1 is the sources; every vertex of region r is reached by an arc from
/// region r - 1, and by none from before it. The fewest arcs from the sources to a vertex are its number - 1.
struct Regions {
  IdVector<VertexId, std::uint32_t> number;  ///< region of each vertex (the paper's T); 0: in none
  std::vector<VertexId> order;               ///< the vertices, region by region (the paper's R)
  std::vector<std::uint32_t> first{0};       ///< region r is order[first[r - 1]] .. before order[first[r]]

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(first.size() - 1); }
  /// The vertices of region r, 1 <= r <= count().
  [[nodiscard]] std::span<const VertexId> region(std::uint32_t r) const {
    return std::span(order).subspan(first[r - 1], first[r] - first[r - 1]);
  }
};

/// Elementary operations of a partition: what the paper's O(4 E) and O(E^2) count.
struct PartitionOperations {
  std::uint64_t table = 0;        ///< reads and writes of the region table (second form)
  std::uint64_t comparisons = 0;  ///< of two vertices (first form)
};

/// The paper's optimised partition (Table 2), in O(V + E). Its two tables, "has a region" and "was already
/// dispatched", are one here: a vertex gets its number when it is dispatched. Repeated sources count once.
/// With `until`, ends after the first region by whose end all of `until` have a number; if one of them is out
/// of reach, it runs to the end. Vertices beyond the last region then have no number.
template <Direction direction>
void partition(const Digraph& graph, std::span<const VertexId> sources, Regions& out,
               std::span<const VertexId> until = {});

/// The same, counted: each arc reads the table once and each vertex writes it once, at most 2 (E + sources).
template <Direction direction>
void partition(const Digraph& graph, std::span<const VertexId> sources, Regions& out,
               PartitionOperations& operations);

/// The paper's first form (Table 1), by comparing arrays, in O(E^2): the baseline of its runtime table.
/// It removes only the current and the fore region from the leaves, so it equals `partition` where every arc
/// has its reverse, and elsewhere may put a vertex into several regions: `order` then repeats it and `number`
/// is its last region. On a long enough cycle it never ends by itself: it is stopped after `max_regions`
/// (0: the number of vertices, which a right partition never exceeds), and returns false.
template <Direction direction>
bool partition_first_form(const Digraph& graph, std::span<const VertexId> sources, Regions& out,
                          std::uint32_t max_regions = 0, PartitionOperations* operations = nullptr);

}  // namespace thalweg
