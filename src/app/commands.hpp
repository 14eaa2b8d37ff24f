// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/options.hpp"

namespace thalweg {

/// Each subcommand takes its arguments (without program and command) and returns the exit code.
int run_command(std::span<const std::string> arguments);
int compare_command(std::span<const std::string> arguments);
int days_command(std::span<const std::string> arguments);
int route_command(std::span<const std::string> arguments);
int network_command(std::span<const std::string> arguments);
int lab_command(std::span<const std::string> arguments);
int doctor_command(std::span<const std::string> arguments);

/// The options of `run`, which `thalweg --save-template` writes for sumolib.
Options run_options();

}  // namespace thalweg
