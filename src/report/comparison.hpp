// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "report/statistics.hpp"
#include "report/trips.hpp"

namespace thalweg {

/// A strategy or a baseline, and its runs: one a seed. Failed runs are kept, and left out of every mean.
struct Arm {
  std::string name;
  std::vector<RunSummary> runs{};
};

struct Comparison {
  std::string thalweg{};  ///< versions
  std::string sumo{};
  std::string configuration{};
  std::string command{};
  std::vector<std::uint64_t> seeds{};
  std::vector<Arm> arms{};
};

/// The mean commute of one arm less that of another, in seconds, over the seeds that succeeded in both.
struct Difference {
  std::string arm;
  std::string baseline;
  Estimate paired{};         ///< seed by seed
  Estimate welch{};          ///< as if the seeds were independent
  double baseline_mean = 0;  ///< of the same seeds
  std::optional<double> correlation{};
  /// More seeds until the paired interval is within 1 % of the baseline's mean.
  std::optional<std::size_t> more_seeds{};

  [[nodiscard]] double relative() const { return paired.mean / baseline_mean; }
};

/// The arms that all others are held against, when they are present.
inline constexpr std::array<const char*, 2> baselines{"static", "device"};

/// The mean over the runs that succeeded, of whatever `value` reads from each.
template <class Value>
Estimate estimate_over_runs(const Arm& arm, Value value) {
  std::vector<double> values;
  for (const RunSummary& run : arm.runs) {
    const auto number = static_cast<double>(value(run));
    if (!run.failed() && number - number == 0) values.push_back(number);
  }
  return estimate(values);
}

/// Mean commute over all vehicles.
Estimate commute(const Arm& arm);

/// Every arm against every baseline, in the arms' order, the baselines' order inside. An arm without a seed
/// that succeeded in both is left out.
std::vector<Difference> differences(const Comparison& comparison);

/// As in comparison.json: docs name its keys, which are never renamed. What is absent or not finite is null.
nlohmann::ordered_json to_json(const Comparison& comparison);
void write_json(const Comparison& comparison, const std::filesystem::path& file);

/// run.json of a run's folder: the entry of comparison.json, with the arm's name.
nlohmann::ordered_json to_json(const RunSummary& run);
RunSummary run_from_json(const nlohmann::ordered_json& json);  ///< InputError: not such an object
void write_json(const RunSummary& run, const std::filesystem::path& file);
/// What is no UTF-8 in it (SUMO's words may hold anything) is replaced.
void write_json(const nlohmann::ordered_json& json, const std::filesystem::path& file);
RunSummary read_run(const std::filesystem::path& file);  ///< InputError: missing or no run.json

}  // namespace thalweg
