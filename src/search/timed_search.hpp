// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <concepts>
#include <optional>
#include <vector>

#include "core/id.hpp"
#include "core/time.hpp"
#include "graph/digraph.hpp"

namespace thalweg {

/// When one leaves an arc that was entered at a time: a callable (ArcId, Millis) -> Millis, never before the
/// entry; infinity closes the arc. The paper's dynamical weight function f(t, I).
template <class F>
concept ArrivalFunction = requires(const F& arrive, ArcId arc, Millis entry) {
  { arrive(arc, entry) } -> std::convertible_to<Millis>;
};

/// Storage of `timed_search`, to be reused; one a thread.
class TimedScratch {
 public:
  struct Entry {
    Millis key;  ///< label + potential
    Millis label;
    VertexId vertex;
    friend bool operator<(const Entry& a, const Entry& b) {  // the standard's heap keeps the greatest on top
      return a.key != b.key ? a.key > b.key : a.vertex.value > b.vertex.value;
    }
  };
  struct Label {
    Millis time = infinity;
    ArcId parent{};
    std::uint32_t search = 0;  ///< the search that wrote it
  };
  void begin(std::size_t vertices) {
    heap.clear();
    if (labels.size() == vertices && ++search != 0) return;
    labels.assign(vertices, {});
    search = 1;
  }
  [[nodiscard]] Millis time(VertexId v) const {
    return labels[v].search == search ? labels[v].time : infinity;
  }

  std::vector<Entry> heap;
  IdVector<VertexId, Label> labels;
  std::uint32_t search = 0;
};

struct TimedPath {
  Millis arrival = infinity;  ///< at the destination
  std::vector<ArcId> arcs;
};

/// The earliest arrival at `destination` for one that is at `origin` at `start`; nullopt: none before
/// `bound`. A* on the time labels (Dreyfus 1969 for the label-setting): exact where leaving later never
/// arrives earlier and `potential` (VertexId -> Millis) is never above the time that is left, nor falls by
/// more than an arc takes; infinity where the destination is out of reach.
template <ArrivalFunction F, class Potential>
std::optional<TimedPath> timed_search(const Digraph& graph, VertexId origin, Millis start,
                                      VertexId destination, Millis bound, const F& arrive,
                                      const Potential& potential, TimedScratch& scratch) {
  scratch.begin(graph.vertex_count());
  const auto reach = [&](VertexId v, Millis time, ArcId parent) {
    if (time >= scratch.time(v)) return;
    const Millis key = add_saturating(time, potential(v));
    if (key >= bound) return;
    scratch.labels[v] = {.time = time, .parent = parent, .search = scratch.search};
    scratch.heap.push_back({.key = key, .label = time, .vertex = v});
    std::push_heap(scratch.heap.begin(), scratch.heap.end());
  };
  reach(origin, start, ArcId{});
  while (!scratch.heap.empty()) {
    std::pop_heap(scratch.heap.begin(), scratch.heap.end());
    const auto [key, label, vertex] = scratch.heap.back();
    scratch.heap.pop_back();
    if (label > scratch.time(vertex)) continue;  // an earlier one came first
    if (vertex == destination) {
      TimedPath path{.arrival = label, .arcs = {}};
      for (ArcId arc = scratch.labels[vertex].parent; arc.valid();) {
        path.arcs.push_back(arc);
        arc = scratch.labels[graph.ends(arc).tail].parent;
      }
      std::reverse(path.arcs.begin(), path.arcs.end());
      return path;
    }
    for (const Arc& arc : graph.out(vertex)) reach(arc.end, arrive(arc.id, label), arc.id);
  }
  return std::nullopt;
}

}  // namespace thalweg
