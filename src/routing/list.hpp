// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "routing/strategy.hpp"

namespace thalweg {

// A new strategy: one file with its make function, a line here, an entry in strategy.cpp.
std::unique_ptr<Strategy> make_hybrid(const StrategyOptions& options);
std::unique_ptr<Strategy> make_evolved(const StrategyOptions& options);
std::unique_ptr<Strategy> make_forecast(const StrategyOptions& options);
std::unique_ptr<Strategy> make_booking(const StrategyOptions& options);
std::unique_ptr<Strategy> make_marginal(const StrategyOptions& options);
std::unique_ptr<Strategy> make_memory(const StrategyOptions& options);
std::unique_ptr<Strategy> make_cch(const StrategyOptions& options);
/// `cch` with the hierarchy for every batch, however small. Not in the list: for tests and measurements.
std::unique_ptr<Strategy> make_hierarchy(const StrategyOptions& options);
std::unique_ptr<Strategy> make_dijkstra(const StrategyOptions& options);

}  // namespace thalweg
