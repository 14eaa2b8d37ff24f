// SPDX-License-Identifier: Apache-2.0
#include "traffic/conditions.hpp"

#include <algorithm>

namespace thalweg {

Conditions::Conditions(const Network& network, std::vector<LaneChange> changes)
    : network_(network), changes_(std::move(changes)), active_(changes_.size(), false) {
  for (const LaneChange& change : changes_) roads_.push_back(network.lanes[change.lane].road);
  std::sort(roads_.begin(), roads_.end());
  roads_.erase(std::unique(roads_.begin(), roads_.end()), roads_.end());
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

bool Conditions::closed(RoadId road, VehicleClass vehicle_class) const {
  const Road& own = network_.roads[road];
  for (std::uint32_t k = 0; k < own.lane_count; ++k) {
    const LaneId lane{own.first_lane.value + k};
    Permissions permissions = network_.lanes[lane].permissions;
    for (std::size_t i = 0; i < changes_.size(); ++i) {
      if (active_[i] && changes_[i].lane == lane) permissions = permissions & changes_[i].permissions;
    }
    if (permissions.allows(vehicle_class) && permissions != Permissions::none()) return false;
  }
  return true;
}

double Conditions::crossing(RoadId road) const {
  const Road& own = network_.roads[road];
  double speed = 0;
  for (std::uint32_t k = 0; k < own.lane_count; ++k) {
    const LaneId lane{own.first_lane.value + k};
    double limit = network_.lanes[lane].speed;
    for (std::size_t i = 0; i < changes_.size(); ++i) {
      if (active_[i] && changes_[i].lane == lane && changes_[i].speed) limit = *changes_[i].speed;
    }
    speed = std::max(speed, limit);
  }
  return network_.lanes[own.first_lane].length / std::max(0.1, speed);
}

}  // namespace thalweg
