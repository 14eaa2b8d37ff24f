// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "app/options.hpp"
#include "routing/strategy.hpp"
#include "simulation/control.hpp"

namespace thalweg {

/// The options of `run` and `compare` that say how vehicles are re-routed, with the defaults of the structs
/// that they fill.
std::vector<OptionSpec> routing_options();
/// SUMO's --weights.*-penalty.
std::vector<OptionSpec> penalty_options();
/// --threads.
OptionSpec threads_option();

/// InputError: a value out of its range.
ControlOptions control_options(const Options& options);
StrategyOptions strategy_options(const Options& options);
TurnPenalties turn_penalties(const Options& options);
std::size_t thread_count(const Options& options);

}  // namespace thalweg
