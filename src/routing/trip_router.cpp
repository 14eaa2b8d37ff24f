// SPDX-License-Identifier: Apache-2.0
#include "routing/trip_router.hpp"

#include <fmt/format.h>

#include "core/nearest.hpp"
#include "traffic/weight_file.hpp"

namespace thalweg {

TripRouter::TripRouter(const Network& network, Setting setting, std::unique_ptr<Strategy> strategy)
    : network_(network), setting_(std::move(setting)), strategy_(std::move(strategy)) {}

std::size_t TripRouter::traffic_of(VehicleClass vehicle_class, double max_speed) {
  const auto [index, is_new] = traffic_index_.try_emplace({vehicle_class, max_speed}, traffic_.size());
  if (!is_new) return index->second;
  auto& graph = graphs_[vehicle_class];
  if (!graph) graph = std::make_unique<RoadGraph>(network_, vehicle_class);
  ClassTraffic traffic{.graph = graph.get(), .free_flow = {}, .road_times = {}, .turn_costs = {}};
  traffic.free_flow = free_flow_times(network_, vehicle_class, max_speed, setting_.penalties);
  traffic.road_times = traffic.free_flow;
  for (const auto& file : setting_.weight_files) {
    apply_weight_file(file, network_, setting_.time, traffic.road_times);
  }
  turn_costs(*graph, traffic.road_times, traffic.turn_costs);
  traffic_.push_back(std::move(traffic));
  return index->second;
}

std::string TripRouter::add(VehicleClass vehicle_class, double max_speed,
                            std::span<const std::string_view> roads) {
  Traveller traveller;
  traveller.vehicle_class = traffic_of(vehicle_class, max_speed);
  const RoadGraph& graph = *traffic_[traveller.vehicle_class].graph;
  for (const auto name : roads) {
    const auto road = network_.find_road(name);
    if (!road) {
      if (road_names_.empty()) {
        for (const auto& [id, known] : network_.road_ids) road_names_.push_back(id);
      }
      return fmt::format("the edge '{}' is not in the net{}", name, did_you_mean(name, road_names_));
    }
    const VertexId vertex = graph.vertex(*road);
    if (!vertex.valid()) return fmt::format("the edge '{}' is within a junction", name);
    if (!graph.permitted(vertex)) {
      return fmt::format("the edge '{}' is forbidden for the class '{}'", name, name_of(vehicle_class));
    }
    if (traveller.route.empty()) {
      traveller.route.push_back(vertex);
    } else if (vertex !=
               (traveller.waypoints.empty() ? traveller.route.front() : traveller.waypoints.back())) {
      traveller.waypoints.push_back(vertex);
    }
  }
  travellers_.push_back(std::move(traveller));
  return {};
}

std::optional<TripRouter::Found> TripRouter::result(std::size_t i) const {
  const Traveller& traveller = travellers_[i];
  const ClassTraffic& traffic = traffic_[traveller.vehicle_class];
  const auto id = [&](VertexId v) -> const std::string& { return network_.roads[traffic.graph->road(v)].id; };
  if (traveller.waypoints.empty()) {  // from a road to itself
    const VertexId only = traveller.route.front();
    return Found{.edges = id(only), .cost = traffic.road_times[traffic.graph->road(only)]};
  }
  if (decisions_[i].route.empty()) return std::nullopt;
  Found found{.edges = {}, .cost = decisions_[i].new_cost};
  for (const VertexId vertex : decisions_[i].route) {
    if (network_.roads[traffic.graph->road(vertex)].function == RoadFunction::zone) continue;
    if (!found.edges.empty()) found.edges += ' ';
    found.edges += id(vertex);
  }
  return found;
}

}  // namespace thalweg
