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

struct NotCounted {
  void table() {}
};

struct Counted {
  PartitionOperations& operations;
  void table() { ++operations.table; }
};

template <Direction direction, class Counter>
void level(const Digraph& graph, std::span<const VertexId> sources, Regions& out,
           std::span<const VertexId> until, Counter counter) {
  reset(out, graph.vertex_count());
  const auto dispatch = [&](VertexId v, std::uint32_t region) {
    counter.table();
    if (out.number[v] != 0) return;
    counter.table();
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

}  // namespace

template <Direction direction>
void partition(const Digraph& graph, std::span<const VertexId> sources, Regions& out,
               std::span<const VertexId> until) {
  level<direction>(graph, sources, out, until, NotCounted{});
}

template <Direction direction>
void partition(const Digraph& graph, std::span<const VertexId> sources, Regions& out,
               PartitionOperations& operations) {
  operations = {};
  level<direction>(graph, sources, out, {}, Counted{operations});
}

template <Direction direction>
bool partition_first_form(const Digraph& graph, std::span<const VertexId> sources, Regions& out,
                          std::uint32_t max_regions, PartitionOperations* operations) {
  std::uint64_t comparisons = 0;
  const auto contains = [&comparisons](std::span<const VertexId> vertices, VertexId v) {
    const auto found = std::find(vertices.begin(), vertices.end(), v);
    comparisons += static_cast<std::uint64_t>(found - vertices.begin()) + (found == vertices.end() ? 0U : 1U);
    return found != vertices.end();
  };
  bool ended = true;
  reset(out, graph.vertex_count());
  if (max_regions == 0) max_regions = static_cast<std::uint32_t>(graph.vertex_count());
  std::vector<VertexId> leaves;  // the paper's alpha
  for (const VertexId source : sources) {
    if (!contains(leaves, source)) leaves.push_back(source);
  }
  while (!leaves.empty()) {
    if (out.count() == max_regions) {
      ended = false;
      break;
    }
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
  if (operations != nullptr) *operations = {.table = 0, .comparisons = comparisons};
  return ended;
}

template void partition<Direction::forward>(const Digraph&, std::span<const VertexId>, Regions&,
                                            PartitionOperations&);
template void partition<Direction::backward>(const Digraph&, std::span<const VertexId>, Regions&,
                                             PartitionOperations&);
template void partition<Direction::forward>(const Digraph&, std::span<const VertexId>, Regions&,
                                            std::span<const VertexId>);
template void partition<Direction::backward>(const Digraph&, std::span<const VertexId>, Regions&,
                                             std::span<const VertexId>);
template bool partition_first_form<Direction::forward>(const Digraph&, std::span<const VertexId>, Regions&,
                                                       std::uint32_t, PartitionOperations*);
template bool partition_first_form<Direction::backward>(const Digraph&, std::span<const VertexId>, Regions&,
                                                        std::uint32_t, PartitionOperations*);

}  // namespace thalweg
