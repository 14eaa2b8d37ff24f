// SPDX-License-Identifier: Apache-2.0
#include "traffic/timed_costs.hpp"

#include <algorithm>
#include <cmath>

namespace thalweg {

TimedCosts::TimedCosts(const Network& network, const RoadGraph& graph)
    : graph_(graph),
      road_times_(free_flow_times(network, graph.vehicle_class(), default_max_speed(graph.vehicle_class()),
                                  {.minor = 0, .turnaround = 0, .signal = 0})) {
  turn_costs(graph, road_times_, free_flow_);
}

void TimedCosts::refresh(const QueueForecast& forecast, const Residuals& residuals,
                         const Conditions& conditions, Millis now) {
  const std::size_t bins = forecast.options().bins;
  now_ = now;
  bin_ = forecast.options().bin;
  horizon_ = bin_ * static_cast<Millis>(bins - 1);
  nodes_ = bins;
  costs_.resize(free_flow_.size() * nodes_);
  const double bin = to_seconds(bin_);
  std::vector<double> fading(bins);
  for (std::size_t b = 0; b < bins; ++b)
    fading[b] = std::exp(-static_cast<double>(b) * bin / residuals.options().fading);

  const Digraph& turns = graph_.turns();
  std::vector<double> slower(road_times_.size());  // s above free flow, by road
  std::vector<bool> is_closed(turns.arc_count());
  for (const RoadId road : conditions.roads()) {
    slower[road.value] = std::max(0.0, conditions.crossing(road) - to_seconds(road_times_[road]));
  }
  for (const ArcId turn : conditions.closed_turns(graph_)) is_closed[turn.value] = true;
  std::vector<double> road_delay(bins);  // of the road that is left: one computation for all its turns
  for (std::size_t v = 0; v < turns.vertex_count(); ++v) {
    const auto out = turns.out(VertexId{v});
    if (out.empty()) continue;
    const RoadId road = graph_.road(VertexId{v});
    const double crossing = slower[road.value] + to_seconds(road_times_[road]);
    for (std::size_t b = 0; b < bins; ++b) {
      // Waits stand for the middles of their bins.
      const double at =
          std::clamp(static_cast<double>(b) + crossing / bin - 0.5, 0.0, static_cast<double>(bins - 1));
      const auto left = static_cast<std::size_t>(at);
      const std::size_t right = std::min(left + 1, bins - 1);
      const double share = at - static_cast<double>(left);
      const double wait = forecast.wait(road, left) * (1 - share) + forecast.wait(road, right) * share;
      road_delay[b] = slower[road.value] + wait + residuals[road] * fading[b];
    }
    for (const Arc& arc : out) {
      double junction = 0;
      for (const RoadId internal : graph_.junction_roads(arc.id)) junction += residuals[internal];
      std::int32_t* cost = costs_.data() + arc.id.value * nodes_;
      if (is_closed[arc.id.value]) {
        std::fill_n(cost, bins, static_cast<std::int32_t>(closed));
        continue;
      }
      const Millis least = std::min<Millis>(free_flow_[arc.id.value], closed);
      for (std::size_t b = 0; b < bins; ++b) {
        const double delay = std::clamp(road_delay[b] + junction * fading[b], 0.0, 100'000.0);
        const auto value = static_cast<std::int32_t>(least + static_cast<Millis>(delay * 1000));
        cost[b] = b == 0 ? value : std::max(value, cost[b - 1] - static_cast<std::int32_t>(bin_));
      }
    }
  }
}

}  // namespace thalweg
