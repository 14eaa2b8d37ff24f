// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>

#include "demand/demand.hpp"

namespace thalweg {

/// How far a run was from Wardrop's equilibrium, in which nobody could have arrived earlier by another way
/// (Wardrop 1952): the finished trips' own routes and the fastest there were, both by the travel times that
/// the run itself recorded and from the moment the vehicle was inserted, so that the gap is never below 0.
/// It is an upper estimate: the fastest way is chosen by times that few vehicles left behind where traffic is
/// thin, so that a lucky green looks like a fast road, and one vehicle's gain is not that of all who would
/// follow.
struct RelativeGap {
  std::uint64_t trips = 0;
  std::uint64_t gaining = 0;  ///< their own route took over 5 % longer than the fastest
  double own_s = 0;           ///< sum over the trips
  double best_s = 0;

  /// NaN without trips.
  [[nodiscard]] double relative() const {
    return best_s > 0 ? (own_s - best_s) / best_s : std::numeric_limits<double>::quiet_NaN();
  }
  [[nodiscard]] double gaining_share() const {
    return static_cast<double>(gaining) / static_cast<double>(trips);
  }
};

/// From SUMO's --vehroute-output and an edgeData output with a period and internal roads. Left out: fixed
/// vehicles, those with stops, those that did not finish, and routes that their class may not drive. `via`
/// is kept on the fastest way, too. InputError: a file is missing or of another kind.
RelativeGap relative_gap(const std::filesystem::path& routes, const std::filesystem::path& edge_data,
                         const Network& network, const Demand& demand);

}  // namespace thalweg
