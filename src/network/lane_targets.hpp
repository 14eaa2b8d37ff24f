// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "network/network.hpp"

namespace thalweg {

/// The road that each lane leads to, where all its connections lead to the same one; else invalid.
[[nodiscard]] IdVector<LaneId, RoadId> lane_targets(const Network& network);

}  // namespace thalweg
