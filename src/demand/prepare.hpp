// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <filesystem>
#include <string_view>

#include "demand/demand.hpp"
#include "sumo/configuration.hpp"
#include "sumo/installation.hpp"

namespace thalweg {

/// The files of a prepared demand, all within one folder.
struct DemandFiles {
  explicit DemandFiles(std::filesystem::path place) : folder(std::move(place)) {}
  std::filesystem::path folder;
  [[nodiscard]] std::filesystem::path given() const {
    return folder / "given.rou.xml";
  }  ///< routes as demanded
  [[nodiscard]] std::filesystem::path free_flow() const {
    return folder / "static.rou.xml";
  }  ///< on the empty net
  [[nodiscard]] std::filesystem::path state() const {
    return folder / "state.xml";
  }  ///< where the run begins with one
  [[nodiscard]] std::filesystem::path dropped() const { return folder / "dropped.xml"; }
};

/// Makes the user's demand (route files and what additional files hold of it) into one file of vehicles with
/// explicit routes, by duarouter, once before all arms: flows expanded, trips routed on free flow, given
/// routes kept; types, depart attributes, stops and `via` kept; public transport and persons as they are.
/// What cannot be routed is left out and listed with its reason. `settings`: the configuration, paths
/// absolute; `header`: a comment on top of the files; `stop` ends it. InputError when duarouter fails or was
/// stopped, or there is nobody to simulate. Without vehicles when only persons, containers, calibrators or a
/// state that is loaded have any.
Demand prepare_demand(const Settings& settings, const Network& network, const SumoInstallation& sumo,
                      const DemandFiles& files, std::string_view header, const std::atomic<bool>& stop);

/// Reads a prepared demand back. InputError when the folder holds none.
Demand read_prepared_demand(const Settings& settings, const Network& network, const DemandFiles& files);

}  // namespace thalweg
