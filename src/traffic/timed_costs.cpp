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

void TimedCosts::refresh(const Expectation& expected, Millis now) {
  now_ = now;
  bin_ = expected.forecast.bin();
  nodes_ = expected.forecast.bins();
  horizon_ = bin_ * static_cast<Millis>(nodes_ - 1);
  costs_.resize(free_flow_.size() * nodes_);
  to_end_.resize(graph_.turns().vertex_count());
  delay_.resize(nodes_);
  fading_.resize(nodes_);
  for (std::size_t b = 0; b < nodes_; ++b)
    fading_[b] = std::exp(-static_cast<double>(b) * to_seconds(bin_) / expected.residuals.options().fading);
  take_conditions(expected.conditions);
  for (std::size_t v = 0; v < graph_.turns().vertex_count(); ++v) refresh_vertex(expected, VertexId{v});
}

void TimedCosts::refresh(const Expectation& expected, RoadId road) {
  const VertexId vertex = graph_.vertex(road);
  if (vertex.valid()) refresh_vertex(expected, vertex);
}

void TimedCosts::take_conditions(const Conditions& conditions) {
  slower_.assign(road_times_.size(), 0);
  is_closed_.assign(graph_.turns().arc_count(), false);
  for (const RoadId road : conditions.roads())
    slower_[road.value] = std::max(0.0, conditions.crossing(road) - to_seconds(road_times_[road]));
  for (const ArcId turn : conditions.closed_turns(graph_)) is_closed_[turn.value] = true;
}

void TimedCosts::refresh_vertex(const Expectation& expected, VertexId v) {
  const auto out = graph_.turns().out(v);
  const RoadId road = graph_.road(v);
  if (out.empty()) {
    to_end_[v.value] = road_times_[road];
    return;
  }
  const Residuals& residuals = expected.residuals;
  const double bin = to_seconds(bin_);
  const double extra =
      slower_[road.value] + expected.level.extra(expected.servers, road) + residuals.lasting(road);
  const double crossing = to_seconds(road_times_[road]) + extra;
  for (std::size_t b = 0; b < nodes_; ++b) {  // of the road that is left: one computation for all its turns
    // Waits stand for the middles of their bins.
    const double at =
        std::clamp(static_cast<double>(b) + crossing / bin - 0.5, 0.0, static_cast<double>(nodes_ - 1));
    const auto left = static_cast<std::size_t>(at);
    const std::size_t right = std::min(left + 1, nodes_ - 1);
    const double share = at - static_cast<double>(left);
    const double wait =
        expected.bookings.wait(road, left) * (1 - share) + expected.bookings.wait(road, right) * share;
    delay_[b] = extra + wait + residuals.passing(road) * fading_[b];
  }
  to_end_[v.value] = road_times_[road] + from_seconds(delay_[0]);
  for (const Arc& arc : out) {
    std::int32_t* cost = costs_.data() + arc.id.value * nodes_;
    if (is_closed_[arc.id.value]) {
      std::fill_n(cost, nodes_, static_cast<std::int32_t>(closed));
      continue;
    }
    double passing = 0;
    double lasting = 0;
    for (const RoadId internal : graph_.junction_roads(arc.id)) {
      passing += residuals.passing(internal);
      lasting += expected.level.extra(expected.servers, internal) + residuals.lasting(internal);
    }
    const Millis least = std::min<Millis>(free_flow_[arc.id.value], closed);
    for (std::size_t b = 0; b < nodes_; ++b) {
      const double delay = std::clamp(delay_[b] + lasting + passing * fading_[b], 0.0, 100'000.0);
      const auto value = static_cast<std::int32_t>(least + static_cast<Millis>(delay * 1000));
      cost[b] = b == 0 ? value : std::max(value, cost[b - 1] - static_cast<std::int32_t>(bin_));
    }
  }
}

}  // namespace thalweg
