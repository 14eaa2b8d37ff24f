// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "network/network.hpp"

namespace thalweg {

/// The lane that a connection leaves.
[[nodiscard]] inline LaneId lane_of(const Network& network, const Connection& connection) {
  return network.roads[connection.from].lane(connection.from_lane);
}

/// Where a lane leads to.
struct LaneTarget {
  RoadId road;
  LaneId lane;  ///< the last one in the net, where there are several
};

/// Of each lane, where all its connections lead to the same road; else invalid ids.
[[nodiscard]] IdVector<LaneId, LaneTarget> lane_targets(const Network& network);

}  // namespace thalweg
