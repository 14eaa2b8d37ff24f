// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "app/options.hpp"

namespace thalweg {

/// Whether --configuration-file names a file of the command's own options (and not one of SUMO's).
enum class OwnConfiguration : std::uint8_t { no, yes };

/// What every subcommand begins with: reads its arguments and its own configuration, answers --help and the
/// like, and opens the log. False: the command is done with that.
bool start(Options& options, std::span<const std::string> arguments, OwnConfiguration configuration);

}  // namespace thalweg
