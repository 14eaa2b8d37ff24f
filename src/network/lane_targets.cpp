// SPDX-License-Identifier: Apache-2.0
#include "network/lane_targets.hpp"

namespace thalweg {

IdVector<LaneId, LaneTarget> lane_targets(const Network& network) {
  IdVector<LaneId, LaneTarget> targets(network.lanes.size());
  IdVector<LaneId, bool> has_choice(network.lanes.size(), false);
  for (const Connection& connection : network.connections) {
    const LaneId lane = lane_of(network, connection);
    const LaneTarget here{.road = connection.to,
                          .lane = network.roads[connection.to].lane(connection.to_lane)};
    LaneTarget& target = targets[lane];
    if (target.road.valid() && target.road != here.road) has_choice[lane] = true;
    target = has_choice[lane] ? LaneTarget{} : here;
  }
  return targets;
}

}  // namespace thalweg
