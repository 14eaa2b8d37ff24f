// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cassert>
#include <concepts>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "graph/digraph.hpp"
#include "search/region_paths.hpp"
#include "search/regions.hpp"

namespace thalweg {

/// What the paper's dynamical system accumulates on the way: an index I and a weight w. Plain numbers, no
/// times.
struct Accumulated {
  std::int64_t index = 0;
  std::int64_t weight = 0;
  auto operator<=>(const Accumulated&) const = default;
};

/// f(t, I) of the paper: the weight of the arc on which a path enters vertex t, when its index is then I.
template <class F>
concept IndexedWeight = requires(const F& f, VertexId vertex, std::int64_t index) {
  { f(vertex, index) } -> std::convertible_to<std::int64_t>;
};

/// What an arc adds to the index: I_(s, t).
template <class D>
concept ArcIndex = requires(const D& d, ArcId arc) {
  { d(arc) } -> std::convertible_to<std::int64_t>;
};

/// W[t][I]: a row of weights for each vertex. What an index past the end of a row weighs is not said by the
/// paper: here `beyond`.
struct WeightTable {
  std::size_t row_length = 0;
  std::vector<std::int64_t> weights;  ///< rows one after the other
  std::int64_t beyond = 0;

  [[nodiscard]] std::int64_t operator()(VertexId vertex, std::int64_t index) const {
    const auto column = static_cast<std::size_t>(index);
    return column < row_length ? weights[vertex.value * row_length + column] : beyond;
  }
};

/// A weight that changes at some indices, the same at every vertex: `weights[k]` from index `from[k]` on
/// (ascending, the first at most the least index).
struct StepWeight {
  std::vector<std::int64_t> from;
  std::vector<std::int64_t> weights;

  [[nodiscard]] std::int64_t operator()(VertexId /*vertex*/, std::int64_t index) const {
    const auto next = std::upper_bound(from.begin(), from.end(), index);
    assert(next != from.begin());
    return weights[static_cast<std::size_t>(next - from.begin()) - 1];
  }
};

/// w = c I.
struct LinearWeight {
  std::int64_t factor = 1;
  [[nodiscard]] std::int64_t operator()(VertexId /*vertex*/, std::int64_t index) const {
    return factor * index;
  }
};

template <ArcIndex D, IndexedWeight F>
[[nodiscard]] Accumulated extended(const Accumulated& at, const Arc& arc, VertexId head, const D& index,
                                   const F& weight) {
  const std::int64_t i = at.index + index(arc.id);
  return {.index = i, .weight = at.weight + weight(head, i)};
}

/// Labels of the one-label searches in a dynamical system.
struct AccumulatedTree {
  static constexpr std::int64_t unreached = std::numeric_limits<std::int64_t>::max();
  IdVector<VertexId, Accumulated> label;  ///< weight `unreached`: no label
  IdVector<VertexId, ArcId> parent;
};

/// Hybrid in a dynamical system: each vertex keeps one label, the candidate of least weight from the fore
/// region (of equals the arc with the lowest id), with that candidate's index. Not exact among the fewest-arc
/// paths: a heavier label may have the index that pays later. The sources start with `start`.
template <ArcIndex D, IndexedWeight F>
void hybrid_accumulated(const Digraph& graph, const Regions& regions, const D& index, const F& weight,
                        AccumulatedTree& out, const Accumulated& start = {}) {
  out.label.assign(graph.vertex_count(), {.weight = AccumulatedTree::unreached});
  out.parent.assign(graph.vertex_count(), ArcId{});
  if (regions.count() == 0) return;
  for (const VertexId source : regions.region(1)) out.label[source] = start;
  for (std::size_t i = regions.first[1]; i < regions.order.size(); ++i) {
    const VertexId u = regions.order[i];
    for (const Arc& arc : graph.in(u)) {
      if (regions.number[arc.end] + 1 != regions.number[u] || regions.number[arc.end] == 0) continue;
      const Accumulated candidate = extended(out.label[arc.end], arc, u, index, weight);
      if (out.parent[u].valid() && candidate.weight >= out.label[u].weight) continue;
      out.label[u] = candidate;
      out.parent[u] = arc.id;
    }
  }
}

/// What a path really accumulates, arc by arc from `start`.
template <ArcIndex D, IndexedWeight F>
[[nodiscard]] Accumulated accumulated_on(const Digraph& graph, std::span<const ArcId> path, const D& index,
                                         const F& weight, Accumulated start = {}) {
  for (const ArcId arc : path) {
    const VertexId head = graph.ends(arc).head;
    start = extended(start, Arc{.end = head, .id = arc}, head, index, weight);
  }
  return start;
}

/// The weights at `target` of all fewest-arc paths, ascending and without repetition: the paper's sequence X,
/// whose first is the exact optimum among them. By region, with the set of different (index, weight) pairs at
/// each vertex: the same numbers as the enumeration of all paths (RegionPaths) gives, without walking each.
template <ArcIndex D, IndexedWeight F>
[[nodiscard]] std::vector<std::int64_t> distinct_weights(const Digraph& graph, const Regions& regions,
                                                         VertexId target, const D& index, const F& weight,
                                                         const Accumulated& start = {}) {
  std::vector<std::int64_t> out;
  const std::uint32_t last = regions.number[target];
  if (last == 0) return out;
  IdVector<VertexId, std::vector<Accumulated>> at(graph.vertex_count());
  for (const VertexId source : regions.region(1)) at[source] = {start};
  for (std::uint32_t r = 2; r <= last; ++r) {
    for (const VertexId u : regions.region(r)) {
      auto& own = at[u];
      for (const Arc& arc : graph.in(u)) {
        if (regions.number[arc.end] != r - 1) continue;
        for (const Accumulated& label : at[arc.end]) own.push_back(extended(label, arc, u, index, weight));
      }
      std::sort(own.begin(), own.end());
      own.erase(std::unique(own.begin(), own.end()), own.end());
    }
    for (const VertexId v : regions.region(r - 1)) at[v] = {};
  }
  for (const Accumulated& label : at[target]) out.push_back(label.weight);
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace thalweg
