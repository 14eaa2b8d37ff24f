// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

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

/// Runs a program and waits for it; what it prints goes to `log`. Returns its exit code (128 + n: signal n).
/// InputError when it cannot be started.
int run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                const std::filesystem::path& log);

/// The whole text of a small file; empty when it cannot be read.
std::string read_text(const std::filesystem::path& file);

/// InputError with SUMO's advice unless the tool is there.
void require_tool(const std::filesystem::path& tool, const std::string& name);

}  // namespace thalweg
