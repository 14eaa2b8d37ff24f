// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "app/options.hpp"
#include "demand/prepare.hpp"
#include "network/lane_changes.hpp"
#include "simulation/arm.hpp"
#include "sumo/installation.hpp"
#include "sumo/options.hpp"

namespace thalweg {

/// What `run` and `compare` start from: the user's configuration with what the command line says on top.
struct Project {
  std::string name;  ///< the file that names it in reports: the configuration, or the net when there is none
  SumoInstallation sumo;
  SumoOptions catalogue;
  Settings settings;  ///< SUMO's, by their proper names, paths absolute
  std::filesystem::path output;
  Network network;
  Demand demand;
  DemandFiles demand_files{std::filesystem::path()};
  std::vector<LaneChange> lane_changes;  ///< what the additional files do to lanes on the way
};

/// The options that `run` and `compare` share.
std::vector<OptionSpec> project_options();

/// Reads the configuration and the net, and prepares the demand (or reads the one named by --prepared).
/// `check` looks at the command's own options once the configuration is read, before the work begins.
Project load_project(Options& options, const std::function<void(const SumoOptions&)>& check);

/// Tells which of the user's outputs come under another name than his, or not at all because no arm writes
/// them (device.rerouting.output), that the settings of SUMO's device are those of the arms, and which closed
/// road is open to an arm with that device.
void warn_of_arms(const Project& project, std::span<const ArmSpec> arms);

}  // namespace thalweg
