// SPDX-License-Identifier: Apache-2.0
#include "cch/width.hpp"

#include <algorithm>

namespace thalweg {
namespace {

using W = std::uint32_t;
constexpr W none = cch_infinity<W>;

/// The dearest open arc that leaves the vertex.
Millis dearest(const Digraph& graph, const std::vector<Millis>& costs, VertexId v) {
  Millis most = 0;
  for (const Arc& arc : graph.out(v)) {
    if (costs[arc.id.value] < infinity) most = std::max(most, costs[arc.id.value]);
  }
  return most;
}

}  // namespace

bool fits_32_bits(const Digraph& graph, const std::vector<Millis>& costs) {
  Millis sum = 0;
  for (std::size_t v = 0; v < graph.vertex_count() && sum < static_cast<Millis>(none); ++v) {
    sum = add_saturating(sum, dearest(graph, costs, VertexId{v}));
  }
  return sum < static_cast<Millis>(none);
}

bool fits_32_bits(const Digraph& graph, const std::vector<Millis>& costs, const CchTopology& topology,
                  const CchMetric<W>& metric) {
  struct Ways {
    W to_top = none;
    W from_top = none;
  };
  std::vector<Ways> ways(topology.vertex_count());
  Ways longest{.to_top = 0, .from_top = 0};
  Millis apart = 0;
  for (std::size_t v = topology.vertex_count(); v-- > 0;) {
    Ways& own = ways[v];
    if (v + 1 == topology.vertex_count()) own = {.to_top = 0, .from_top = 0};
    const auto rank = static_cast<CchTopology::Rank>(v);
    for (auto edge = topology.first_edge(rank); edge < topology.first_edge(rank + 1); ++edge) {
      const Ways& higher = ways[topology.head(edge)];
      own.to_top = std::min<W>(own.to_top, metric.up[edge] + higher.to_top);
      own.from_top = std::min<W>(own.from_top, higher.from_top + metric.down[edge]);
    }
    const Millis most = dearest(graph, costs, topology.order()[v]);
    if (own.to_top < none) {
      longest.to_top = std::max(longest.to_top, own.to_top);
    } else {
      apart = add_saturating(apart, most);
    }
    if (own.from_top < none) {
      longest.from_top = std::max(longest.from_top, own.from_top);
    } else {
      apart = add_saturating(apart, most);
    }
  }
  const auto joined = static_cast<Millis>(longest.to_top) + static_cast<Millis>(longest.from_top);
  return add_saturating(apart, joined) < static_cast<Millis>(none);
}

}  // namespace thalweg
