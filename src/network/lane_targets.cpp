// SPDX-License-Identifier: Apache-2.0
#include "network/lane_targets.hpp"

namespace thalweg {

IdVector<LaneId, LaneTarget> lane_targets(const Network& network) {
  IdVector<LaneId, LaneTarget> targets(network.lanes.size());
  IdVector<LaneId, bool> has_choice(network.lanes.size(), false);
  for (const Connection& connection : network.connections) {
    const LaneId lane = network.roads[connection.from].lane(connection.from_lane);
    LaneTarget& target = targets[lane];
    if (target.road.valid() && target.road != connection.to) has_choice[lane] = true;
    target = {.road = connection.to, .lane = network.roads[connection.to].lane(connection.to_lane)};
    if (has_choice[lane]) target = {};
  }
  return targets;
}

}  // namespace thalweg
