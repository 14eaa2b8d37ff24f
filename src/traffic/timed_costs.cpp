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
  least_.resize(free_flow_.size());
  least_in_mean_.resize(free_flow_.size());
  to_end_.resize(graph_.turns().vertex_count());
  delay_.resize(nodes_);
  fading_.resize(nodes_);
  late_.resize(nodes_);
  for (std::size_t b = 0; b < nodes_; ++b) {
    const double ahead = static_cast<double>(b) * to_seconds(bin_);
    fading_[b] = expected.residuals.passing_left(ahead);
    late_[b] = expected.residuals.late_share(ahead);
  }
  take_conditions(expected.conditions);
  take_signals(expected);
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

void TimedCosts::take_signals(const Expectation& expected) {
  const Servers& servers = expected.servers;
  const Digraph& turns = graph_.turns();
  forecast_ = &expected.forecast;
  signal_waits_ = &servers.signal_waits();
  if (movements_.empty()) {
    movements_.reserve(turns.arc_count());
    for (std::size_t i = 0; i < turns.arc_count(); ++i) {
      const auto [tail, head] = turns.ends(ArcId{i});
      movements_.push_back(servers.find(graph_.road(tail), graph_.road(head)));
    }
  }
  after_line_.assign(movements_.size(), -1);
  for (std::size_t i = 0; i < movements_.size(); ++i) {
    if (is_closed_[i] || !signal_waits_->knows(movements_[i])) continue;
    const Movement& movement = servers[movements_[i]];
    const double through = expected.level.junction_pace() * movement.through;
    after_line_[i] = from_seconds(movement.delay + through);
  }
}

Millis TimedCosts::in_phase(ArcId turn, Millis entry, Millis out) const {
  // Who waits for longer, in s, is let go when the queue is, whatever is shown.
  constexpr double longest_queue = 10;
  const Millis at_line = out - after_line_[turn.value];
  const double ahead = to_seconds(at_line - now_);
  const RoadId road = graph_.road(graph_.turns().ends(turn).tail);
  const double share = 1 - forecast_->queue(road, forecast_->bin_at(ahead)) / longest_queue;
  if (share <= 0) return out;
  const double deviation = signal_waits_->deviation(movements_[turn.value], at_line, ahead);
  return std::max(entry + free_flow_[turn.value], out + from_seconds(share * deviation));
}

void TimedCosts::refresh_vertex(const Expectation& expected, VertexId v) {
  const auto out = graph_.turns().out(v);
  const RoadId road = graph_.road(v);
  if (out.empty()) {
    to_end_[v.value] = road_times_[road];
    return;
  }
  const Residuals& residuals = expected.residuals;
  const double passing_here = residuals.passing(road);
  const double late_here = residuals.late(road);
  const double extra =
      slower_[road.value] + expected.level.extra(expected.servers, road) + residuals.lasting(road);
  // Of the road that is left: one computation for all its turns. Waits stand for the middles of their bins.
  const double later = (to_seconds(road_times_[road]) + extra) / to_seconds(bin_) - 0.5;  // in bins
  const double share = later - std::floor(later);
  const auto last = static_cast<std::ptrdiff_t>(nodes_) - 1;
  const auto wait = [&](std::ptrdiff_t b) {
    return static_cast<double>(
        expected.bookings.wait(road, static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(b, 0, last))));
  };
  auto left = static_cast<std::ptrdiff_t>(std::min(std::floor(later), static_cast<double>(last)));
  double at_left = wait(left);
  for (std::size_t b = 0; b < nodes_; ++b) {
    const double at_right = wait(++left);
    const double delay =
        extra + at_left * (1 - share) + at_right * share + passing_here * fading_[b] + late_here * late_[b];
    delay_[b] = std::min(delay, 100'000.0);
    at_left = at_right;
  }
  to_end_[v.value] = road_times_[road] + from_seconds(delay_[0]);
  for (const Arc& arc : out) {
    if (is_closed_[arc.id.value]) {
      std::fill_n(costs_.data() + arc.id.value * nodes_, nodes_, static_cast<std::int32_t>(closed));
      least_[arc.id.value] = least_in_mean_[arc.id.value] = infinity;
      continue;
    }
    double passing = 0;
    double lasting = 0;
    for (const RoadId internal : graph_.junction_roads(arc.id)) {
      passing += residuals.passing(internal);
      lasting += expected.level.extra(expected.servers, internal) + residuals.lasting(internal);
    }
    if (graph_.turns_back(arc.id) && expected.forecast.taken(graph_.road(arc.end)) >= crowded)
      lasting += turned_back;
    refresh_turn(arc.id, lasting, passing);
  }
}

void TimedCosts::refresh_turn(ArcId turn, double lasting, double passing) {
  std::int32_t* const cost = costs_.data() + turn.value * nodes_;
  const double* const delay = delay_.data();
  const double* const fading = fading_.data();
  const auto free_flow = static_cast<std::int32_t>(std::min<Millis>(free_flow_[turn.value], closed));
  const std::size_t nodes = nodes_;
  for (std::size_t b = 0; b < nodes; ++b) {  // several at once, since nothing in it branches
    const auto later = static_cast<std::int32_t>((delay[b] + lasting + passing * fading[b]) * 1000);
    cost[b] = free_flow + std::max(later, 0);
  }
  const auto bin = static_cast<std::int32_t>(bin_);
  std::int32_t before = cost[0];
  std::int32_t least = before;
  for (std::size_t b = 1; b < nodes; ++b) {
    before = std::max(cost[b], before - bin);
    cost[b] = before;
    least = std::min(least, before);
  }
  least_[turn.value] = least_in_mean_[turn.value] = least;
  if (after_line_[turn.value] < 0) return;
  const Millis in_green = least - from_seconds(signal_waits_->mean(movements_[turn.value])) - 1;
  least_[turn.value] = std::max<Millis>(free_flow, in_green);
}

}  // namespace thalweg
