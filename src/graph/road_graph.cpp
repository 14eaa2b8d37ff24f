// SPDX-License-Identifier: Apache-2.0
#include "graph/road_graph.hpp"

#include <algorithm>
#include <string_view>
#include <unordered_map>

#include "network/right_of_way.hpp"

namespace thalweg {
namespace {

/// The internal road that follows an internal road, where the way through the junction has more than one.
/// The last connection that the net lists counts, as in SUMO's routers.
IdVector<RoadId, RoadId> next_internal_roads(const Network& network) {
  IdVector<RoadId, RoadId> next(network.roads.size());
  for (const Connection& c : network.connections) {
    if (network.roads[c.from].function != RoadFunction::internal) continue;
    next[c.from] = c.via.valid() ? network.lanes[c.via].road : RoadId{};
  }
  return next;
}

bool usable(const Network& network, const Connection& c, VehicleClass vehicle_class) {
  const auto lane = [&](RoadId road, std::uint32_t index) {
    return network.lanes[network.roads[road].lane(index)].permissions;
  };
  Permissions permissions = lane(c.from, c.from_lane) & lane(c.to, c.to_lane) & c.permissions;
  if (c.via.valid()) permissions = permissions & network.lanes[c.via].permissions;
  return permissions.allows(vehicle_class);
}

struct Turn {
  ArcEnds ends;
  RoadId via;
  bool turns_back;
  auto operator<=>(const Turn&) const = default;
};

}  // namespace

RoadGraph::RoadGraph(const Network& network, VehicleClass vehicle_class)
    : vehicle_class_(vehicle_class), vertices_(network.roads.size()) {
  for (std::size_t i = 0; i < network.roads.size(); ++i) {
    const Road& road = network.roads[RoadId{i}];
    if (road.function != RoadFunction::normal && road.function != RoadFunction::zone) continue;
    vertices_[RoadId{i}] = roads_.push_back(RoadId{i});
    Permissions any = Permissions::none();
    for (const LaneId lane : road.lanes()) any = any | network.lanes[lane].permissions;
    permitted_.push_back(any.allows(vehicle_class));
  }

  std::vector<Turn> turns;
  for (const Connection& c : network.connections) {
    if (!vertices_[c.from].valid() || !vertices_[c.to].valid()) continue;
    if (!usable(network, c, vehicle_class)) continue;
    turns.push_back({.ends = {.tail = vertices_[c.from], .head = vertices_[c.to]},
                     .via = c.via.valid() ? network.lanes[c.via].road : RoadId{},
                     .turns_back = is_turnaround(c)});
  }
  std::sort(turns.begin(), turns.end());
  turns.erase(std::unique(turns.begin(), turns.end()), turns.end());

  const auto next = next_internal_roads(network);
  std::vector<ArcEnds> arcs;
  arcs.reserve(turns.size());
  junction_first_.reserve(turns.size() + 1);
  for (const Turn& turn : turns) {
    if (arcs.empty() || arcs.back() != turn.ends) ++turn_count_;
    arcs.push_back(turn.ends);
    turns_back_.push_back(turn.turns_back);
    junction_first_.push_back(static_cast<std::uint32_t>(junction_roads_.size()));
    const std::size_t first = junction_roads_.size();
    for (RoadId road = turn.via; road.valid(); road = next[road]) {
      const bool is_loop = std::find(junction_roads_.begin() + static_cast<std::ptrdiff_t>(first),
                                     junction_roads_.end(), road) != junction_roads_.end();
      if (is_loop) break;  // a damaged net must not hang us
      junction_roads_.push_back(road);
    }
  }
  junction_first_.push_back(static_cast<std::uint32_t>(junction_roads_.size()));
  turns_ = Digraph(roads_.size(), arcs);
}

RoadTimes free_flow_times(const Network& network, VehicleClass vehicle_class, double max_speed,
                          const TurnPenalties& penalties) {
  std::unordered_map<std::string_view, double> limits;  // by type of road
  for (const auto& restriction : network.restrictions) {
    if (restriction.vehicle_class == vehicle_class) limits[restriction.type] = restriction.speed;
  }
  RoadTimes times(network.roads.size());
  for (std::size_t i = 0; i < network.roads.size(); ++i) {
    const Road& road = network.roads[RoadId{i}];
    double length = 0;
    double speed = 0;
    for (const LaneId id : road.lanes()) {
      const Lane& lane = network.lanes[id];
      if (id != road.first_lane && lane.speed <= speed) continue;
      speed = lane.speed;
      length = lane.length;
    }
    if (const auto limit = limits.find(road.type); limit != limits.end()) speed = limit->second;
    times[RoadId{i}] = from_seconds(length / std::min(speed, max_speed));
  }
  IdVector<RoadId, Millis> penalty(network.roads.size(), 0);
  for (const Connection& c : network.connections) {
    if (!c.via.valid()) continue;
    Millis& own = penalty[network.lanes[c.via].road];
    // As in SUMO's routers the last of these counts: a signalled turn-around costs what a signal costs.
    if (gives_way(c.state)) own = penalties.minor;
    if (is_turnaround(c)) own = penalties.turnaround;
    if (c.signal.valid()) own = penalties.signal;
  }
  for (std::size_t i = 0; i < times.size(); ++i) {
    times[RoadId{i}] = add_saturating(times[RoadId{i}], penalty[RoadId{i}]);
  }
  return times;
}

void turn_costs(const RoadGraph& graph, const RoadTimes& times, std::vector<Millis>& costs) {
  const Digraph& turns = graph.turns();
  costs.resize(turns.arc_count());
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const ArcId turn{i};
    Millis cost = times[graph.road(turns.ends(turn).tail)];
    for (const RoadId road : graph.junction_roads(turn)) cost = add_saturating(cost, times[road]);
    costs[i] = cost;
  }
}

}  // namespace thalweg
