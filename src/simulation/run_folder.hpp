// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "demand/prepare.hpp"
#include "simulation/arm.hpp"

namespace thalweg {

/// The folder of one run: SUMO's configuration as it was run, and every output.
struct RunFolder {
  std::filesystem::path folder;
  std::filesystem::path configuration;  ///< run.sumocfg: plain `sumo -c` repeats a baseline that has no `via`
  std::filesystem::path tripinfo;
  std::filesystem::path statistics;
  std::filesystem::path routes;     ///< of vehicles, as driven
  std::filesystem::path edge_data;  ///< travel times by intervals of five minutes, junctions included
  std::filesystem::path errors;     ///< SUMO's warnings and errors
};

/// A setting of the user's for SUMO's device, which is left out: the device is as the arm has it. Its output
/// is kept where the arm has the device.
bool is_overruled(std::string_view name, const ArmSpec& arm);

/// An output that we read must be XML under a known name.
bool is_readable_output(std::string_view file);

/// Makes the folder ready: the user's configuration with the prepared demand in place of his, outputs and
/// detectors' files moved into the folder, device.rerouting as the arm has it and nothing else. `header`: a
/// comment on top of it.
RunFolder make_run_folder(const std::filesystem::path& folder, const Settings& user,
                          const SumoOptions& options, const DemandFiles& demand, const ArmSpec& arm,
                          std::uint64_t seed, std::string_view header);

}  // namespace thalweg
