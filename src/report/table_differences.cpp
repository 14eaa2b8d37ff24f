// SPDX-License-Identifier: Apache-2.0
#include "report/table_sections.hpp"

namespace thalweg {
namespace {

/// "-29.9 to -23.9", each times `unit`.
std::string range_text(const Estimate& estimate, double unit) {
  if (!estimate.half_width) return "-";
  return fmt::format("{} to {}", decimals(*estimate.low() * unit, 1, true),
                     decimals(*estimate.high() * unit, 1, true));
}

}  // namespace

void print_differences(const Comparison& comparison, const Labels& labels, std::string& out) {
  const auto all = differences(comparison);
  bool marked = false;
  for (const char* baseline : baselines) {
    Cells names;
    Cells seconds;
    Cells second_ranges;
    Cells percents;
    Cells percent_ranges;
    Cells marks;
    Cells welch_ranges;
    Cells correlations;
    Cells more_seeds;
    for (const Difference& difference : all) {
      if (difference.baseline != baseline) continue;
      const Estimate& paired = difference.paired;
      const double percent = 100 / difference.baseline_mean;
      names.push_back(labels.find(comparison.arms, difference.arm));
      seconds.push_back(decimals(paired.mean, 1, true));
      second_ranges.push_back(range_text(paired, 1));
      percents.push_back(decimals(paired.mean * percent, 1, true));
      percent_ranges.push_back(range_text(paired, percent));
      marks.emplace_back(paired.differs_from_zero() ? "*" : "");
      welch_ranges.push_back(range_text(difference.welch, 1));
      correlations.push_back(difference.correlation ? decimals(*difference.correlation, 2, true) : "-");
      more_seeds.push_back(difference.more_seeds ? fmt::format("{}", *difference.more_seeds) : "-");
      marked = marked || paired.differs_from_zero();
    }
    if (names.empty()) continue;
    TextTable table(fmt::format("Mean commute less that of {}, seed by seed", baseline), std::move(names),
                    labels.width);
    table.column("s", std::move(seconds));
    table.column("95 %", std::move(second_ranges));
    table.column("percent", std::move(percents));
    table.column("95 %", std::move(percent_ranges));
    table.column("", std::move(marks));
    table.column("unpaired, s", std::move(welch_ranges));
    table.column("correlation", std::move(correlations));
    table.column("more seeds", std::move(more_seeds));
    table.print(out);
  }
  if (marked) out += "  * the interval does not contain 0\n";
  if (std::ranges::any_of(all, [](const Difference& difference) { return difference.more_seeds > 0U; })) {
    out += "  more seeds: how many it takes until the interval is ±1 % of the baseline's mean\n";
  }
}

}  // namespace thalweg
