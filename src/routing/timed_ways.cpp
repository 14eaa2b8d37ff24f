// SPDX-License-Identifier: Apache-2.0
#include "routing/timed_ways.hpp"

namespace thalweg {

Millis TimedWays::start(const Traveller& traveller) const {
  if (!traveller.departed) return earliest_insertion(traveller);
  const VertexId front = traveller.route.front();
  if (const auto leaving = foresight_.leaving(traveller.vehicle)) {
    if (leaving->road == graph_.road(front)) return start_in_queue(front, leaving->at);
    const Servers& servers = foresight_.expected().servers;
    const MovementId turn = servers.find(leaving->road, graph_.road(front));
    if (turn.valid()) return leaving->at + from_seconds(servers[turn].through);
  }
  return foresight_.now() + std::max<Millis>(0, traveller.until_route) -
         static_cast<Millis>(traveller.driven * static_cast<double>(crossing(front)));
}

/// The forecast says when it leaves, by its place in the queue. What the costs know of that road's end beside
/// the forecast (residuals, bookings) counts by the share of the road that is still before it.
Millis TimedWays::start_in_queue(VertexId front, Millis leaves) const {
  const Expectation expected = foresight_.expected();
  const RoadId road = graph_.road(front);
  const double crossing = expected.level.pace() * expected.servers.free_flow(road);
  const double foretold =
      crossing + expected.forecast.wait_after(road, crossing);  // who enters now leaves then
  const Millis whole = costs_.to_end(front);
  const double left = to_seconds(leaves - foresight_.now());
  const double more = std::min(1.0, left / std::max(1.0, foretold)) * (to_seconds(whole) - foretold);
  return foresight_.now() + from_seconds(std::max(0.0, left + more)) - whole;
}

Millis TimedWays::insertion(const Traveller& traveller, VertexId second) const {
  const Millis wanted = std::max<Millis>(0, traveller.until_route);
  return foresight_.now() + foresight_.insertion(traveller.vehicle, wanted,
                                                 graph_.road(traveller.route.front()), graph_.road(second));
}

Millis TimedWays::earliest_insertion(const Traveller& traveller) const {
  const VertexId front = traveller.route.front();
  Millis earliest =
      insertion(traveller, traveller.route[std::min<std::size_t>(1, traveller.route.size() - 1)]);
  if (!foresight_.has_lines(graph_.road(front))) return earliest;
  for (const Arc& turn : graph_.turns().out(front))
    earliest = std::min(earliest, insertion(traveller, turn.end));
  return earliest;
}

}  // namespace thalweg
