// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "core/time.hpp"
#include "report/gap.hpp"
#include "simulation/forecast_error.hpp"

namespace thalweg {

/// RunSummary::error of a run that the user ended.
inline constexpr std::string_view was_interrupted = "interrupted";

/// A mean over nothing.
inline constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// What the demand file asked for.
struct DemandedTrip {
  std::string id;
  Millis depart = 0;
  bool fixed = false;         ///< a bus or another vehicle that may not be re-routed
  std::string destination{};  ///< the last road of its route; empty: not known (see read_trips)
  bool equipped = true;       ///< of the share that a router of ours leads (in every arm)
  bool is_past = false;  ///< departs before the run begins: on its way in a state that is loaded, or gone
};

/// Counts of vehicles by their state at the end of a run, and mean times in seconds, lengths in metres.
/// vehicles = finished + running + waiting + discarded + not_loaded (+ RunSummary::dropped in `all`).
struct Group {
  std::uint64_t vehicles = 0;
  std::uint64_t finished = 0;
  std::uint64_t running = 0;
  std::uint64_t waiting = 0;     ///< due, and not yet inserted
  std::uint64_t discarded = 0;   ///< due, and SUMO gave up on it or removed it before it arrived
  std::uint64_t not_loaded = 0;  ///< due at or after the end

  double commute_mean = no_value;   ///< over all that were due, i.e. all but not_loaded
  double duration_mean = no_value;  ///< this and the next three: over the finished
  double depart_delay_mean = no_value;
  double time_loss_mean = no_value;
  double route_length_mean = no_value;
};

/// Teleports, by SUMO's reason for them.
struct Teleports {
  std::uint64_t jam = 0;
  std::uint64_t yield = 0;
  std::uint64_t wrong_lane = 0;
  std::uint64_t collision = 0;

  /// Those that waited too long (--time-to-teleport).
  [[nodiscard]] std::uint64_t stuck() const { return jam + yield + wrong_lane; }
  [[nodiscard]] std::uint64_t total() const { return stuck() + collision; }
};

/// One run of one arm: what a comparison needs to know of it.
struct RunSummary {
  std::string arm{};
  std::uint64_t seed = 0;
  Group all{};                ///< fixed vehicles and those dropped included
  Group fixed{};              ///< the fixed vehicles by themselves
  Group equipped{};           ///< of the others, those that a router of ours leads or would lead ..
  Group unequipped{};         ///< .. and the rest (--share)
  std::uint64_t dropped = 0;  ///< could not be routed, left out before all arms
  std::uint64_t unknown = 0;  ///< in SUMO's output but not in the demand; in no other count
  Teleports teleports{};
  std::uint64_t reroutes = 0;
  std::uint64_t ignored = 0;  ///< changes advised that the driver did not follow (--compliance)
  ForecastError forecast_error{};
  RelativeGap gap{};
  double wall_s = 0;
  double router_cpu_s = 0;
  double simulation_cpu_s = 0;
  double end_s = 0;  ///< the simulated time at which the run ended
  int exit = 0;      ///< not 0: the run failed, and its figures count for nothing
  std::string error{};

  [[nodiscard]] bool failed() const { return exit != 0; }
};

/// Fills `all`, `fixed`, `equipped`, `unequipped`, `unknown` and `end_s` from SUMO's --tripinfo-output,
/// written with .write-unfinished and .write-undeparted; also `reroutes`, as SUMO counts route changes (an
/// arm that knows better overwrites it). `run.dropped` must be set before. `end` is the simulated time at
/// which the run ended.
///
/// The commute of a finished trip is its depart delay + duration; one that is running, waiting or discarded
/// has lasted from its demanded departure until `end`. SUMO writes nothing at all for a vehicle that it
/// discards
/// (--max-depart-delay); nor for one that had arrived when a state was saved that the run begins with, and
/// that counts as not loaded. A vehicle removed on its way (collision, vaporizer) is written as arrived, with
/// the reason: it counts as discarded. The reason "teleport" stands both for one teleported to its
/// destination (finished) and for one removed by --time-to-teleport.remove (discarded): `destination` tells
/// them apart, and without it the vehicle counts as finished.
///
/// InputError: the file is missing, cut short, or no tripinfo.
void read_trips(const std::filesystem::path& tripinfo, std::span<const DemandedTrip> demand, Millis end,
                RunSummary& run);
/// The same for a text in memory; `name` stands in its errors.
void parse_trips(std::string_view tripinfo, const std::string& name, std::span<const DemandedTrip> demand,
                 Millis end, RunSummary& run);

/// Fills `teleports` from SUMO's --statistic-output. InputError as above.
void read_statistics(const std::filesystem::path& statistics, RunSummary& run);
void parse_statistics(std::string_view statistics, const std::string& name, RunSummary& run);

}  // namespace thalweg
