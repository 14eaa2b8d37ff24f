// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>

#include "graph/road_graph.hpp"
#include "routing/foresight.hpp"
#include "routing/strategy.hpp"
#include "traffic/timed_costs.hpp"

namespace thalweg {

/// The ways of one vehicle class as the forecast expects them to be driven: when one sets out, when one
/// arrives, and what one owes the others.
class TimedWays {
 public:
  /// `toll`: share of what a vehicle costs the others that counts as a cost of its own.
  TimedWays(const Foresight& foresight, const RoadGraph& graph, const TimedCosts& costs, double toll)
      : foresight_(foresight), graph_(graph), costs_(costs), toll_(toll) {}

  /// A way as it will be driven.
  struct Drive {
    Millis arrival = 0;  ///< on its last road; infinity: never
    Millis owed = 0;
  };

  /// When it enters the first road of its route, at the earliest where it waits for its insertion. One that
  /// is on it is as one that entered so much earlier as leaves when it does.
  [[nodiscard]] Millis start(const Traveller& traveller) const;
  /// Its share of what it costs the others that it enters the road at this time.
  [[nodiscard]] Millis toll(VertexId road, Millis time) const {
    if (toll_ <= 0) return 0;
    const QueueTable& table = foresight_.table();
    return from_seconds(
        toll_ * static_cast<double>(table.toll(graph_.road(road), table.bin_at(reaches_end(road, time)))));
  }
  /// In s from the forecast on, of one that enters the road at this time.
  [[nodiscard]] double reaches_end(VertexId road, Millis time) const {
    return to_seconds(time + crossing(road) - foresight_.forecast_at());
  }
  /// A whole crossing of the road, nobody in the way.
  [[nodiscard]] Millis crossing(VertexId road) const {
    return foresight_.driven(costs_.road_time(graph_.road(road)));
  }

  /// When the traveller has made a turn, having entered the road before it at a time. One that waits for its
  /// insertion does so in the line of its first turn: it may get on the road later than at `begin`.
  [[nodiscard]] auto arrivals(const Traveller& traveller, Millis begin) const {
    const VertexId front = traveller.route.front();
    const bool has_lines = !traveller.departed && foresight_.has_lines(graph_.road(front));
    return [this, &traveller, begin, front, has_lines](ArcId turn, Millis time) {
      const bool gets_on = has_lines && time == begin && graph_.turns().ends(turn).tail == front;
      return costs_.arrive(turn, gets_on ? insertion(traveller, graph_.turns().ends(turn).head) : time);
    };
  }

  /// Calls `enters(i, time)` for each road of the route but the last.
  template <class Enters>
  Drive drive(const Traveller& traveller, std::span<const VertexId> route, Millis begin,
              const Enters& enters) const {
    const auto arrive = arrivals(traveller, begin);
    Drive result;
    Millis time = begin;
    for (std::size_t i = 0; i + 1 < route.size() && time < infinity; ++i) {
      enters(i, time);
      result.owed += toll(route[i], time);
      Millis next = infinity;
      for (const Arc& arc : graph_.turns().out(route[i])) {
        if (arc.end == route[i + 1]) next = std::min(next, arrive(arc.id, time));
      }
      time = next;
    }
    result.arrival = never(begin, time) ? infinity : time;
    return result;
  }
  [[nodiscard]] Drive drive(const Traveller& traveller, std::span<const VertexId> route, Millis begin) const {
    return drive(traveller, route, begin, [](std::size_t, Millis) {});
  }

  /// The way leads through a closed road.
  static bool never(Millis begin, Millis arrival) { return arrival - begin >= TimedCosts::closed / 2; }

 private:
  [[nodiscard]] Millis insertion(const Traveller& traveller, VertexId second) const;
  [[nodiscard]] Millis earliest_insertion(const Traveller& traveller) const;
  [[nodiscard]] Millis start_in_queue(VertexId front, Millis leaves) const;

  const Foresight& foresight_;
  const RoadGraph& graph_;
  const TimedCosts& costs_;
  double toll_;
};

}  // namespace thalweg
