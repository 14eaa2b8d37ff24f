// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/text_table.hpp"

namespace thalweg {

/// The parts of what `format_table` prints, and what they share.

/// Names too long for a column get a number, and a line of their own below the heading.
struct Labels {
  static constexpr std::size_t longest_label = 28;
  std::vector<std::string> of_arm{};
  std::string legend{};
  std::size_t width = 0;

  explicit Labels(const std::vector<Arm>& arms) {
    std::size_t number = 0;
    for (const Arm& arm : arms) {
      std::string label = arm.name;
      if (width_of(label) > longest_label) {
        label = fmt::format("{}… [{}]", label.substr(0, std::min(label.find(':'), std::size_t{15}) + 1),
                            ++number);
        legend += fmt::format("  [{}] {}\n", number, arm.name);
      }
      width = std::max(width, width_of(label));
      of_arm.push_back(std::move(label));
    }
  }

  [[nodiscard]] const std::string& find(const std::vector<Arm>& arms, std::string_view name) const {
    const auto arm = std::ranges::find(arms, name, &Arm::name);
    return of_arm[static_cast<std::size_t>(arm - arms.begin())];
  }
};

template <class Value>
double mean_over_runs(const Arm& arm, Value value) {
  return estimate_over_runs(arm, value).mean;
}

/// A cell an arm.
template <class Cell>
Cells cells_of(const std::vector<const Arm*>& arms, Cell cell) {
  Cells cells;
  for (const Arm* arm : arms) cells.push_back(cell(*arm));
  return cells;
}

/// The mean over each arm's runs.
template <class Value>
Cells means_of(const std::vector<const Arm*>& arms, int digits, Value value) {
  return cells_of(arms, [&](const Arm& arm) { return decimals(mean_over_runs(arm, value), digits); });
}

/// The mean of a count: whole numbers when all are whole, else one decimal in the whole column.
template <class Value>
Cells counts_of(const std::vector<const Arm*>& arms, Value value) {
  const bool whole = std::ranges::all_of(arms, [&](const Arm* arm) {
    const double mean = mean_over_runs(*arm, value);
    return !std::isfinite(mean) || mean == std::floor(mean);
  });
  return means_of(arms, whole ? 0 : 1, value);
}

/// Each arm's mean commute less that of the baselines.
void print_differences(const Comparison& comparison, const Labels& labels, std::string& out);
/// How far the routes are from an equilibrium, by each run's own travel times.
void print_gaps(const Comparison& comparison, const Labels& labels, std::string& out);
/// How well the arms with a router of ours predicted arrivals.
void print_forecast_errors(const Comparison& comparison, const Labels& labels, std::string& out);

}  // namespace thalweg
