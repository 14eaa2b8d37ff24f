// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "simulation/control.hpp"

namespace thalweg {

/// Writes every decision of a run (--decision-output): time, vehicle, old and new route with their costs in
/// seconds, the arrival predicted then and the one that came. A kept way has no newRoute.
void write_decisions(const std::filesystem::path& file, std::string_view header, const Network& network,
                     const Demand& demand, const RunResult& result);

}  // namespace thalweg
