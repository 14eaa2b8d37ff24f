// SPDX-License-Identifier: Apache-2.0
#include "traffic/conditions.hpp"

#include <algorithm>

namespace thalweg {

Conditions::Conditions(const Network& network, std::vector<LaneChange> changes)
    : network_(network), changes_(std::move(changes)), active_(changes_.size(), false) {
  for (const LaneChange& change : changes_) roads_.push_back(network.lanes[change.lane].road);
  std::sort(roads_.begin(), roads_.end());
  roads_.erase(std::unique(roads_.begin(), roads_.end()), roads_.end());
  for (std::size_t i = 0; i < network.connections.size() && !roads_.empty(); ++i) {
    const Connection& c = network.connections[ConnectionId{i}];
    const auto is_one = [&](RoadId road) { return std::binary_search(roads_.begin(), roads_.end(), road); };
    if (is_one(c.from) || is_one(c.to)) connections_.emplace_back(i);
  }
}

bool Conditions::advance(Millis now) {
  bool is_new = false;
  for (std::size_t i = 0; i < changes_.size(); ++i) {
    const bool is_active = changes_[i].begin <= now && now < changes_[i].end;
    is_new = is_new || is_active != active_[i];
    active_[i] = is_active;
  }
  if (is_new) ++version_;
  return is_new;
}

bool Conditions::open(LaneId lane, VehicleClass vehicle_class) const {
  Permissions permissions = network_.lanes[lane].permissions;
  for (std::size_t i = 0; i < changes_.size(); ++i) {
    if (active_[i] && changes_[i].lane == lane) permissions = permissions & changes_[i].permissions;
  }
  return permissions.allows(vehicle_class) && permissions != Permissions::none();
}

bool Conditions::closed(RoadId road, VehicleClass vehicle_class) const {
  const Road& own = network_.roads[road];
  for (const LaneId lane : own.lanes()) {
    if (open(lane, vehicle_class)) return false;
  }
  return true;
}

std::vector<ArcId> Conditions::closed_turns(const RoadGraph& graph) const {
  const VehicleClass own = graph.vehicle_class();
  const auto may_pass = [&](RoadId road, std::uint32_t lane) {
    return open(network_.roads[road].lane(lane), own);
  };
  std::vector<ArcId> touched;
  std::vector<ArcId> passable;
  for (const ConnectionId id : connections_) {
    const Connection& c = network_.connections[id];
    const VertexId from = graph.vertex(c.from);
    if (!from.valid() || !graph.vertex(c.to).valid()) continue;
    const RoadId via = c.via.valid() ? network_.lanes[c.via].road : RoadId{};
    for (const Arc& turn : graph.turns().out(from)) {
      const auto inside = graph.junction_roads(turn.id);
      if (turn.end != graph.vertex(c.to) || (inside.empty() ? RoadId{} : inside.front()) != via) continue;
      touched.push_back(turn.id);
      const bool leaves = may_pass(c.from, c.from_lane) || closed(c.from, own);
      if (leaves && may_pass(c.to, c.to_lane)) passable.push_back(turn.id);
    }
  }
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  std::sort(passable.begin(), passable.end());
  std::erase_if(touched,
                [&](ArcId turn) { return std::binary_search(passable.begin(), passable.end(), turn); });
  return touched;
}

double Conditions::crossing(RoadId road) const {
  const Road& own = network_.roads[road];
  double speed = 0;
  for (const LaneId lane : own.lanes()) {
    double limit = network_.lanes[lane].speed;
    for (std::size_t i = 0; i < changes_.size(); ++i) {
      if (active_[i] && changes_[i].lane == lane && changes_[i].speed) limit = *changes_[i].speed;
    }
    speed = std::max(speed, limit);
  }
  return network_.lanes[own.first_lane].length / std::max(0.1, speed);
}

}  // namespace thalweg
