// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "simulation/simulation.hpp"

namespace thalweg {

/// Positions in the plan's route, ascending, that a vehicle with this `via` must keep: its stops, what is
/// left of its `via`, its end. Empty: a stop is not on the route, so that the vehicle had better be left
/// alone.
std::vector<std::size_t> kept_positions(const Plan& plan, std::span<const RoadId> via);

}  // namespace thalweg
