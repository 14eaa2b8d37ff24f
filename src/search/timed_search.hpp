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

/// What is owed beside the time for leaving a vertex: a callable (VertexId, Millis) -> Millis, not below 0.
template <class F>
concept TollFunction = requires(const F& toll, VertexId vertex, Millis time) {
  { toll(vertex, time) } -> std::convertible_to<Millis>;
};
inline constexpr auto no_toll = [](VertexId, Millis) -> Millis { return 0; };

/// Storage of `timed_search`, to be reused; one a thread.
class TimedScratch {
 public:
  struct Entry {
    Millis key;    ///< label + potential
    Millis label;  ///< time + owed
    VertexId vertex;
    friend bool operator<(const Entry& a, const Entry& b) {  // the standard's heap keeps the greatest on top
      return a.key != b.key ? a.key > b.key : a.vertex.value > b.vertex.value;
    }
  };
  struct Label {
    Millis cost = infinity;  ///< time + owed
    Millis owed = 0;
    ArcId parent{};
    std::uint32_t search = 0;  ///< the search that wrote it
  };
  void begin(std::size_t vertices) {
    heap.clear();
    if (labels.size() == vertices && ++search != 0) return;
    labels.assign(vertices, {});
    search = 1;
  }
  [[nodiscard]] Millis cost(VertexId v) const {
    return labels[v].search == search ? labels[v].cost : infinity;
  }

  std::vector<Entry> heap;
  IdVector<VertexId, Label> labels;
  std::uint32_t search = 0;
};

/// Not above the time that is left to the destination for one that enters a vertex at a time: a callable
/// (VertexId, Millis time, Millis most) -> Millis; infinity where it is out of reach. Whatever is above
/// `most` is as good as any other such value.
template <class F>
concept PotentialFunction = requires(const F& left, VertexId vertex, Millis time, Millis most) {
  { left(vertex, time, most) } -> std::convertible_to<Millis>;
};

struct TimedPath {
  Millis arrival = infinity;  ///< at the destination
  Millis owed = 0;
  std::vector<ArcId> arcs;
};

/// What a path must keep to be of interest.
struct TimedLimits {
  Millis below = infinity;   ///< arrival + owed is less
  Millis latest = infinity;  ///< the arrival is not later
};

/// The least arrival + owed at `destination` for one that is at `origin` at `start` and owes `owed` already;
/// nullopt: none within the limits. A* on these labels (Dreyfus 1969 for the label-setting): exact where
/// nothing is owed, leaving later never arrives earlier and `potential` is what it says, nor falls by more
/// than an arc takes. With tolls one label a vertex is kept, as in the paper's dynamical hybrid: a way that
/// is worse up to a vertex and would owe less beyond it is not seen.
template <ArrivalFunction F, TollFunction Toll, PotentialFunction Potential>
std::optional<TimedPath> timed_search(const Digraph& graph, VertexId origin, Millis start, Millis owed,
                                      VertexId destination, const TimedLimits& limits, const F& arrive,
                                      const Toll& toll, const Potential& potential, TimedScratch& scratch) {
  scratch.begin(graph.vertex_count());
  const auto reach = [&](VertexId v, Millis time, Millis debt, ArcId parent) {
    const Millis cost = add_saturating(time, debt);
    if (cost >= scratch.cost(v)) return;
    const Millis left = potential(v, time, std::min(limits.below - cost, limits.latest - time));
    const Millis key = add_saturating(cost, left);
    if (key >= limits.below || add_saturating(time, left) > limits.latest) return;
    scratch.labels[v] = {.cost = cost, .owed = debt, .parent = parent, .search = scratch.search};
    scratch.heap.push_back({.key = key, .label = cost, .vertex = v});
    std::push_heap(scratch.heap.begin(), scratch.heap.end());
  };
  reach(origin, start, owed, ArcId{});
  while (!scratch.heap.empty()) {
    std::pop_heap(scratch.heap.begin(), scratch.heap.end());
    const auto [key, label, vertex] = scratch.heap.back();
    scratch.heap.pop_back();
    if (label > scratch.cost(vertex)) continue;  // a better one came first
    const Millis debt = scratch.labels[vertex].owed;
    const Millis time = label - debt;
    if (vertex == destination) {
      TimedPath path{.arrival = time, .owed = debt, .arcs = {}};
      for (ArcId arc = scratch.labels[vertex].parent; arc.valid();) {
        path.arcs.push_back(arc);
        arc = scratch.labels[graph.ends(arc).tail].parent;
      }
      std::reverse(path.arcs.begin(), path.arcs.end());
      return path;
    }
    const Millis more = debt + toll(vertex, time);
    for (const Arc& arc : graph.out(vertex)) reach(arc.end, arrive(arc.id, time), more, arc.id);
  }
  return std::nullopt;
}

}  // namespace thalweg
