// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/options.hpp"
#include "app/project.hpp"
#include "report/trips.hpp"

namespace thalweg {

/// One `thalweg run` in a process of its own: libsumo holds one simulation a process.
struct ChildRun {
  std::string arm;
  std::uint64_t seed = 0;
  std::filesystem::path folder;
  std::vector<std::string> arguments;
};

/// A run of one arm and seed in `folder`: what the command line says, where the prepared demand is, and
/// `more` of thalweg's own options. Outputs that are named for SUMO behind "--" move into the folder.
ChildRun child_run(const Options& options, const Project& project, const std::string& arm, std::uint64_t seed,
                   const std::filesystem::path& folder, std::span<const std::string> more = {});

/// Runs it to its end and reads what it left. A child that died is a failed run with its last words.
RunSummary run_child(const ChildRun& run);

/// The call as one would type it.
std::string command_line(std::string_view command, std::span<const std::string> arguments);

}  // namespace thalweg
