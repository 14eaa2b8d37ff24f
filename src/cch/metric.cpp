// SPDX-License-Identifier: Apache-2.0
#include "cch/metric.hpp"

namespace thalweg {

template <CchWeight W>
void CchMetric<W>::customise(const CchTopology& topology, const std::vector<Millis>& costs) {
  using Rank = CchTopology::Rank;
  constexpr W none = cch_infinity<W>;
  up.assign(topology.edge_count(), none);
  down.assign(topology.edge_count(), none);
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const auto place = topology.place(ArcId{i});
    if (place.is_loop) continue;
    const W cost = costs[i] >= static_cast<Millis>(none) ? none : static_cast<W>(costs[i]);
    W& own = place.upward ? up[place.edge] : down[place.edge];
    own = std::min(own, cost);
  }
  // Lower triangles, from the lowest vertex on: the way x -> v -> y over a vertex v below both.
  edge_to_.resize(topology.vertex_count());
  for (Rank v = 0; v < topology.vertex_count(); ++v) {
    const auto first = topology.first_edge(v);
    const auto last = topology.first_edge(v + 1);
    for (auto lower = first; lower < last; ++lower) {
      const Rank x = topology.head(lower);
      const W to_v = down[lower];
      const W from_v = up[lower];
      if (to_v >= none && from_v >= none) continue;
      // The higher neighbours of v above x are neighbours of x: both lists ascend.
      auto edge = topology.first_edge(x);
      for (auto other = lower + 1; other < last; ++other) {
        const Rank y = topology.head(other);
        while (topology.head(edge) != y) ++edge;
        up[edge] = std::min({up[edge], static_cast<W>(to_v + up[other]), none});
        down[edge] = std::min({down[edge], static_cast<W>(down[other] + from_v), none});
      }
    }
  }
}

bool fits_32_bits(const Digraph& graph, const std::vector<Millis>& costs) {
  constexpr auto limit = static_cast<Millis>(cch_infinity<std::uint32_t>);
  Millis sum = 0;
  for (std::size_t v = 0; v < graph.vertex_count(); ++v) {
    Millis most = 0;
    for (const Arc& arc : graph.out(VertexId{v})) {
      if (costs[arc.id.value] < infinity) most = std::max(most, costs[arc.id.value]);
    }
    sum += most;
    if (sum >= limit) return false;
  }
  return true;
}

template class CchMetric<std::uint32_t>;
template class CchMetric<std::uint64_t>;

}  // namespace thalweg
