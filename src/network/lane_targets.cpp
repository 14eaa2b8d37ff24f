// SPDX-License-Identifier: Apache-2.0
#include "network/lane_targets.hpp"

namespace thalweg {

IdVector<LaneId, RoadId> lane_targets(const Network& network) {
  IdVector<LaneId, RoadId> targets(network.lanes.size());
  IdVector<LaneId, bool> has_choice(network.lanes.size(), false);
  for (const Connection& connection : network.connections) {
    const LaneId lane = network.roads[connection.from].lane(connection.from_lane);
    if (targets[lane].valid() && targets[lane] != connection.to) has_choice[lane] = true;
    targets[lane] = has_choice[lane] ? RoadId{} : connection.to;
  }
  return targets;
}

}  // namespace thalweg
