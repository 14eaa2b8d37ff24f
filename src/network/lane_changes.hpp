// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/time.hpp"
#include "network/network.hpp"

namespace thalweg {

/// What happens to a lane while the simulation runs, from `begin` until before `end`.
struct LaneChange {
  LaneId lane;
  Millis begin = 0;
  Millis end = infinity;
  Permissions permissions = Permissions::all();  ///< only these classes, of those that the net permits
  std::optional<double> speed{};                 ///< m/s, instead of the net's limit
  /// False: SUMO leaves the lane's permissions alone (a `closingReroute` without classes). Its rerouter turns
  /// vehicles round, but its device.rerouting goes on sending them through.
  bool enforced = true;
};

/// The closed roads and lanes of rerouters (`closingReroute`, `closingLaneReroute`) and the limits of
/// variable speed signs in these additional files and those that they name. A `closingReroute` without
/// classes closes its road for everybody. Left out: roads that the net has not, rerouters that are off or
/// that are for some vehicle types only. InputError where SUMO could not read the file either.
std::vector<LaneChange> read_lane_changes(std::span<const std::string> additional_files,
                                          const Network& network);

}  // namespace thalweg
