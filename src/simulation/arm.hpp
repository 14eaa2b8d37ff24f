// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sumo/configuration.hpp"
#include "sumo/options.hpp"

namespace thalweg {

/// One way of routing the demand: a strategy of ours, or a baseline that SUMO runs by itself.
///   given     the routes as the demand has them
///   static    every route the fastest on empty roads
///   one-shot  routed by SUMO at departure, with the speeds of then
///   device    SUMO's device.rerouting, probability 1, period 60
///   device:period=120,probability=0.5   the same with any of its settings
struct ArmSpec {
  std::string name;
  bool ours = false;              ///< a strategy of ours decides
  bool free_flow_routes = false;  ///< starts from static.rou.xml instead of given.rou.xml
  std::vector<Setting> settings;  ///< SUMO's, beside the user's

  [[nodiscard]] bool has_device() const { return !settings.empty(); }  ///< device.rerouting is at work
};

/// InputError with the nearest name: no such arm, no such setting of SUMO's.
ArmSpec parse_arm(std::string_view text, const SumoOptions& options);

/// "given,device:period=120,probability=0.5,evolved": a part with '=' belongs to the device before it.
std::vector<std::string> split_arms(std::string_view list);

/// The name as a folder ("device:period=120" -> "device_period=120").
std::string arm_folder(std::string_view name);

}  // namespace thalweg
