// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "core/time.hpp"
#include "demand/demand.hpp"

namespace thalweg {

/// What the user's demand files say of themselves, before anything is routed.
struct InputScan {
  Millis begin = 0;  ///< given: who departs before it is not in this simulation, as in SUMO
  Millis end = -1;   ///< given: flows with neither an end nor a number end here; below 0: nowhere
  std::unordered_map<std::string, std::string> via;           ///< by id of the vehicle or trip
  std::unordered_map<std::string, std::string> via_of_flows;  ///< by id of the flow
  std::vector<std::string> ids;    ///< of vehicles and trips, in order; flows are not in it
  std::vector<std::string> flows;  ///< their ids, in order
  std::unordered_map<std::string, std::string> broken_routes;  ///< by id: the first road that the net has not
  std::vector<DroppedVehicle> dropped;   ///< name a road that the net has not: duarouter would cut them short
  bool has_given_routes = false;         ///< some vehicle brings its route along
  bool has_others = false;               ///< persons, containers, or calibrators, who insert vehicles
  std::unordered_set<std::string> seen;  ///< ids of all vehicles and trips, to find double ones
  /// The same of flows: theirs may be those of vehicles, as in SUMO.
  std::unordered_set<std::string> seen_flows;
};

/// Copies what a route file or an additional file holds of demand to `copy` (a route file), without the
/// vehicles, trips and flows that name unknown roads or are over before the begin, and notes it in `scan`.
/// InputError: no XML, a double id. False when there was no demand in it, and so no copy.
bool scan_demand(const std::filesystem::path& file, const std::filesystem::path& copy, const Network& network,
                 bool is_additional, InputScan& scan);

/// An element that puts vehicles, persons or containers on the road.
bool is_demand_element(std::string_view element);

}  // namespace thalweg
