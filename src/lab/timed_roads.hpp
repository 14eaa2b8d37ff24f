// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "graph/road_graph.hpp"
#include "search/regions.hpp"

namespace thalweg::lab {

/// Whole seconds: what the exact search walks through one by one.
using Seconds = std::int64_t;
inline constexpr Seconds never = infinity;

/// What each turn costs by the moment it is entered, in whole seconds of at least 1: the travel times of a
/// SUMO recording (edgeData), interval by interval; free flow where it has none, before it and after it.
class TimedCosts {
 public:
  TimedCosts(std::vector<Seconds> begins, std::vector<std::vector<Seconds>> costs)
      : begins_(std::move(begins)), costs_(std::move(costs)) {}
  /// InputError: the file has no intervals, or is at odds with the net.
  static TimedCosts read(const std::filesystem::path& file, const Network& network, const RoadGraph& roads);

  [[nodiscard]] Seconds operator()(ArcId arc, Seconds entry) const;
  /// Where the next interval begins; the first, and the end of the last, too.
  [[nodiscard]] const std::vector<Seconds>& begins() const { return begins_; }

 private:
  std::vector<Seconds> begins_;              ///< ascending
  std::vector<std::vector<Seconds>> costs_;  ///< [0]: before the first; [i + 1]: from begins_[i] on
};

struct Departure {
  VertexId source;
  Seconds time = 0;
};

/// Arrival times, and the arcs that led there.
struct TimedTree {
  IdVector<VertexId, Seconds> arrival;
  IdVector<VertexId, ArcId> parent;
};

/// Hybrid with one label a vertex, the arrival: the earliest from the fore region.
void timed_hybrid(const Digraph& graph, const Regions& regions, const TimedCosts& costs, Departure from,
                  TimedTree& out);

struct TimedEvolution {
  std::uint32_t rounds = 0;
  bool settled = false;
};
/// Evolution with one label a vertex, in place, by number, until nothing arrives earlier (at most V rounds).
TimedEvolution timed_evolution(const Digraph& graph, const TimedCosts& costs, TimedTree& tree);

/// Dijkstra's method with the arrival for a label: exact where leaving later never arrives earlier.
void timed_dijkstra(const Digraph& graph, const TimedCosts& costs, Departure from, TimedTree& out);

/// The earliest arrivals of all walks, whatever the costs: second by second, with every moment at which a
/// vertex can be reached. A walk may visit a vertex twice, where a detour pays because it takes time. Ends
/// when `wanted` vertices were reached, or `horizon` seconds after the departure.
void earliest_arrivals(const Digraph& graph, const TimedCosts& costs, Departure from, std::size_t wanted,
                       Seconds horizon, IdVector<VertexId, Seconds>& out);

/// When the path of the tree's parents really arrives; `never` when they form a cycle.
[[nodiscard]] Seconds replay(const Digraph& graph, const TimedCosts& costs, const TimedTree& tree,
                             Departure from, VertexId target);

}  // namespace thalweg::lab
