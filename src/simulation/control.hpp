// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <vector>

#include "demand/demand.hpp"
#include "network/lane_changes.hpp"
#include "routing/strategy.hpp"
#include "simulation/forecast_error.hpp"
#include "simulation/simulation.hpp"

namespace thalweg {

struct ControlOptions {
  Millis period = 60'000;               ///< each vehicle reconsiders once a period; 0: at every step
  Millis window = 180'000;              ///< over which travel times are averaged
  Millis sample_interval = 5'000;       ///< between two looks at the traffic
  Millis adaptation_interval = 10'000;  ///< between two updates of the travel times that strategies see
  double share = 1.0;                   ///< share of the vehicles that is ours
  double compliance = 1.0;              ///< probability that a driver follows a piece of advice
  std::uint64_t seed = 0;               ///< of the draws for it
  Millis stall = 3'600'000;             ///< without an end, stop when nothing has arrived for so long
  TurnPenalties penalties{};
  std::vector<LaneChange> lane_changes{};  ///< closed roads and slow ones, noticed when they begin
  bool log_decisions = false;
};

struct LoggedDecision {
  Millis time = 0;
  VehicleId vehicle;
  std::vector<RoadId> old_route;  ///< from the first road whose next turn was free
  std::vector<RoadId> new_route;  ///< empty: it keeps its way
  Millis old_cost = 0;
  Millis new_cost = 0;
  Millis predicted_arrival = 0;  ///< on the way that was chosen
};

enum class StopReason : std::uint8_t { emptied, end_reached, stalled, interrupted };

struct RunResult {
  StopReason reason = StopReason::emptied;
  Millis begin = 0;
  Millis end = 0;
  std::uint64_t decisions = 0;
  std::uint64_t reroutes = 0;
  std::uint64_t refused = 0;      ///< routes that SUMO did not take
  std::uint64_t ignored = 0;      ///< changes that the driver did not follow
  std::uint64_t unreachable = 0;  ///< times that there was no way from the road where a vehicle was
  double router_cpu_s = 0;        ///< measuring, deciding and handing over
  double simulation_cpu_s = 0;
  ForecastError forecast_error{};
  std::vector<LoggedDecision> log;
  IdVector<VehicleId, Millis> arrival;  ///< infinity: not arrived
};

/// Runs the simulation to its end. With a strategy its vehicles are re-routed each control period; without
/// one SUMO is on its own. `progress` is called after every step; a set `stop` ends the run.
RunResult control(Simulation& simulation, const Network& network, const Demand& demand, Strategy* strategy,
                  const ControlOptions& options, const std::function<void(const Simulation&)>& progress,
                  const std::atomic<bool>& stop);

}  // namespace thalweg
