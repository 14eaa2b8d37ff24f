// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "simulation/simulation.hpp"

// SUMO's library is behind a module that is loaded when a simulation starts, so that everything else works
// without it and a missing library can be told in words.

extern "C" {
thalweg::Simulation* thalweg_open_sumo(const thalweg::SessionSetup& setup);
const char* thalweg_sumo_version();
}

namespace thalweg {

/// Starts SUMO. One simulation a process. InputError: the library is missing, or SUMO's own words.
std::unique_ptr<Simulation> open_sumo(const SessionSetup& setup);

/// "SUMO 1.28.0"; InputError when the library is missing.
std::string sumo_library_version();

}  // namespace thalweg
