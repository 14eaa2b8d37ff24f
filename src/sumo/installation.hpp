// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace thalweg {

/// The SUMO whose tools are called: the one the program was built against, or $SUMO_HOME if that is gone.
struct SumoInstallation {
  std::filesystem::path home;       ///< SUMO_HOME: where data/ and tools/ are
  std::filesystem::path sumo;       ///< empty when there is none
  std::filesystem::path duarouter;  ///< empty when there is none
};
SumoInstallation find_sumo();

/// Sets what SUMO wants in the environment and the user has not set: SUMO_HOME (or every run warns and
/// validates over the network) and the place of PROJ's data, which the wheel brings along.
void prepare_environment(const SumoInstallation& sumo);

/// InputError with SUMO's advice unless the tool is there.
void require_tool(const std::filesystem::path& tool, const std::string& name);

}  // namespace thalweg
