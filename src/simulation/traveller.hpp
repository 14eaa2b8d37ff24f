// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "graph/road_graph.hpp"
#include "routing/strategy.hpp"
#include "simulation/simulation.hpp"

namespace thalweg {

/// One that is to decide, from the first road of its plan whose next turn is free: its way and what it must
/// not lose of it. Nothing where there is nothing to decide: it is where it wants to be, or the graph of its
/// class lacks a road of its way. Its id, its class and whether it has departed are the caller's to say.
std::optional<Traveller> make_traveller(const Plan& plan, const DemandVehicle& wanted,
                                        const RoadGraph& graph);

/// Until one with this plan that departs in `until_depart` (0: it is on the way) enters the first road whose
/// next turn is free, by these times; below 0 where it is on that road.
Millis until_free_turn(const Plan& plan, Millis until_depart, const RoadTimes& times);

}  // namespace thalweg
