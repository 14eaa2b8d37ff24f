// SPDX-License-Identifier: Apache-2.0
#include "simulation/live_traffic.hpp"

#include <algorithm>

namespace thalweg {

LiveTraffic::LiveTraffic(const Network& network, const Demand& demand, const TurnPenalties& penalties) {
  for (const DemandVehicle& vehicle : demand.vehicles) {
    auto& index = index_[static_cast<std::size_t>(vehicle.vehicle_class)];
    if (vehicle.fixed || index) continue;
    index = graphs_.size();
    graphs_.push_back(std::make_unique<RoadGraph>(network, vehicle.vehicle_class));
    const double max_speed = default_max_speed(vehicle.vehicle_class);
    traffic_.push_back({.graph = graphs_.back().get(),
                        .free_flow = free_flow_times(network, vehicle.vehicle_class, max_speed, penalties),
                        .road_times = {},
                        .turn_costs = {}});
  }
  expire();
}

void LiveTraffic::refresh(std::size_t index, const MeasuredTimes& measured, const Conditions& conditions) {
  if (fresh_[index]) return;
  fresh_[index] = true;
  ClassTraffic& traffic = traffic_[index];
  measured.live(traffic.free_flow, traffic.road_times);
  for (const RoadId road : conditions.roads()) {
    Millis& time = traffic.road_times[road];
    time = std::max(time, from_seconds(conditions.crossing(road)));
  }
  turn_costs(*traffic.graph, traffic.road_times, traffic.turn_costs);
  for (const ArcId turn : conditions.closed_turns(*traffic.graph)) traffic.turn_costs[turn.value] = infinity;
}

}  // namespace thalweg
