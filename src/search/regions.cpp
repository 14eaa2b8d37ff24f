// SPDX-License-Identifier: Apache-2.0
#include "search/regions.hpp"

#include <algorithm>

namespace thalweg {
namespace {

void reset(Regions& out, std::size_t vertices) {
  out.number.assign(vertices, 0);
  out.order.clear();
  out.order.reserve(vertices);
  out.first.assign(1, 0);
}

/// Gives the vertices since the last region to a new one.
void close_region(Regions& out) { out.first.push_back(static_cast<std::uint32_t>(out.order.size())); }

bool contains(std::span<const VertexId> vertices, VertexId v) {
  return std::find(vertices.begin(), vertices.end(), v) != vertices.end();
}

}  // namespace

template <Direction direction>
void partition(const Digraph& graph, std::span<const VertexId> sources, Regions& out,
               std::span<const VertexId> until) {
  reset(out, graph.vertex_count());
  const auto dispatch = [&](VertexId v, std::uint32_t region) {
    if (out.number[v] != 0) return;
    out.number[v] = region;
    out.order.push_back(v);
  };
  for (const VertexId source : sources) dispatch(source, 1);
  std::size_t met = 0;  // until[0 .. met) have a number
  while (out.order.size() > out.first.back()) {
    const std::size_t begin = out.first.back();
    close_region(out);
    while (met < until.size() && out.number[until[met]] != 0) ++met;
    if (!until.empty() && met == until.size()) return;
    const std::uint32_t next = out.count() + 1;
    for (std::size_t i = begin; i < out.first.back(); ++i) {
      for (const Arc& arc : graph.leaving<direction>(out.order[i])) dispatch(arc.end, next);
    }
  }
}

template <Direction direction>
bool partition_first_form(const Digraph& graph, std::span<const VertexId> sources, Regions& out,
                          std::uint32_t max_regions) {
  reset(out, graph.vertex_count());
  if (max_regions == 0) max_regions = static_cast<std::uint32_t>(graph.vertex_count());
  std::vector<VertexId> leaves;  // the paper's alpha
  for (const VertexId source : sources) {
    if (!contains(leaves, source)) leaves.push_back(source);
  }
  while (!leaves.empty()) {
    if (out.count() == max_regions) return false;
    out.order.insert(out.order.end(), leaves.begin(), leaves.end());
    close_region(out);
    for (const VertexId v : leaves) out.number[v] = out.count();
    const auto current = out.region(out.count());
    const auto fore = out.count() > 1 ? out.region(out.count() - 1) : std::span<const VertexId>{};
    leaves.clear();
    for (const VertexId v : current) {
      for (const Arc& arc : graph.leaving<direction>(v)) {
        const bool known = contains(current, arc.end) || contains(fore, arc.end);
        if (!known && !contains(leaves, arc.end)) leaves.push_back(arc.end);
      }
    }
  }
  return true;
}

template void partition<Direction::forward>(const Digraph&, std::span<const VertexId>, Regions&,
                                            std::span<const VertexId>);
template void partition<Direction::backward>(const Digraph&, std::span<const VertexId>, Regions&,
                                             std::span<const VertexId>);
template bool partition_first_form<Direction::forward>(const Digraph&, std::span<const VertexId>, Regions&,
                                                       std::uint32_t);
template bool partition_first_form<Direction::backward>(const Digraph&, std::span<const VertexId>, Regions&,
                                                        std::uint32_t);

}  // namespace thalweg
