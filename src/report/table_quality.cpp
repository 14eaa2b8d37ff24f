// SPDX-License-Identifier: Apache-2.0
#include "report/table_sections.hpp"

namespace thalweg {
namespace {

/// The arms with a run of which `count` is above 0.
template <class Count>
std::vector<const Arm*> arms_with_any(const Comparison& comparison, Count count) {
  std::vector<const Arm*> arms;
  for (const Arm& arm : comparison.arms) {
    if (mean_over_runs(arm, count) > 0) arms.push_back(&arm);
  }
  return arms;
}

Cells names_of(const std::vector<const Arm*>& arms, const Comparison& comparison, const Labels& labels) {
  Cells names;
  for (const Arm* arm : arms) names.push_back(labels.find(comparison.arms, arm->name));
  return names;
}

/// Of all runs together.
HorizonError pooled(const Arm& arm, std::size_t first, std::size_t count) {
  HorizonError sum;
  for (const RunSummary& run : arm.runs) {
    if (run.failed()) continue;
    for (std::size_t i = first; i < first + count; ++i) sum += run.forecast_error[i];
  }
  return sum;
}

/// "34.2 (0.81)": the mean absolute error, and how many times that of the measured times.
std::string error_text(const HorizonError& error) {
  if (error.predictions == 0) return "-";
  return fmt::format("{} ({})", decimals(error.mean(error.own.absolute), 1),
                     decimals(error.own.absolute / error.measured.absolute, 2));
}

std::string horizon_text(std::size_t i) {
  if (i + 1 == horizons.size()) return fmt::format("{}+ min", horizons[i] / 60'000);
  return fmt::format("{}-{} min", horizons[i] / 60'000, horizons[i + 1] / 60'000);
}

}  // namespace

void print_gaps(const Comparison& comparison, const Labels& labels, std::string& out) {
  const auto arms = arms_with_any(comparison, [](const RunSummary& run) { return run.gap.trips; });
  if (arms.empty()) return;
  TextTable table(
      "Distance from equilibrium: routes driven against the fastest, by the run's own travel times",
      names_of(arms, comparison, labels), labels.width);
  table.column("relative gap, %",
               means_of(arms, 1, [](const RunSummary& run) { return 100 * run.gap.relative(); }));
  table.column("could gain over 5 %, % of trips",
               means_of(arms, 1, [](const RunSummary& run) { return 100 * run.gap.gaining_share(); }));
  table.column("trips", counts_of(arms, [](const RunSummary& run) { return run.gap.trips; }));
  table.print(out);
}

void print_forecast_errors(const Comparison& comparison, const Labels& labels, std::string& out) {
  const auto arms = arms_with_any(comparison, [](const RunSummary& run) {
    std::uint64_t predictions = 0;
    for (const HorizonError& error : run.forecast_error) predictions += error.predictions;
    return predictions;
  });
  if (arms.empty()) return;
  TextTable table(
      "Mean absolute error in s of the predicted time left, "
      "by the time that was left (x that of the measured times)",
      names_of(arms, comparison, labels), labels.width);
  for (std::size_t i = 0; i < horizons.size(); ++i) {
    table.column(horizon_text(i),
                 cells_of(arms, [&](const Arm& arm) { return error_text(pooled(arm, i, 1)); }));
  }
  const auto all_of = [](const Arm& arm) { return pooled(arm, 0, horizons.size()); };
  table.column("all", cells_of(arms, [&](const Arm& arm) { return error_text(all_of(arm)); }));
  const auto bias = [&](ErrorSums HorizonError::*whose) {
    return cells_of(arms, [&](const Arm& arm) {
      const HorizonError all = all_of(arm);
      return decimals(100 * (all.*whose).difference / all.realised, 1, true);
    });
  };
  table.column("bias, %", bias(&HorizonError::own));
  table.column("of measured, %", bias(&HorizonError::measured));
  table.print(out);
}

}  // namespace thalweg
