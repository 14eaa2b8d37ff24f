// SPDX-License-Identifier: Apache-2.0
#include "report/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace thalweg {
namespace {

constexpr std::size_t longest_label = 28;
constexpr std::size_t line_width = 120;

/// Columns on a terminal: here one a code point.
std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

using Cells = std::vector<std::string>;

/// A title, and below it columns: the labels to the left, all others to the right.
class TextTable {
 public:
  TextTable(std::string title, Cells labels, std::size_t label_width)
      : title_(std::move(title)), labels_(std::move(labels)), label_width_(label_width) {}

  void column(std::string head, Cells cells) {
    cells.insert(cells.begin(), std::move(head));
    columns_.push_back(std::move(cells));
  }

  void print(std::string& out) const {
    out += fmt::format("\n{}\n", title_);
    for (std::size_t row = 0; row <= labels_.size(); ++row) {
      const std::string label = row == 0 ? "" : labels_[row - 1];
      std::string line = "  " + label + std::string(label_width_ - width_of(label), ' ');
      for (const Cells& column : columns_) {
        std::size_t width = 0;
        for (const auto& cell : column) width = std::max(width, width_of(cell));
        line += "  " + std::string(width - width_of(column[row]), ' ') + column[row];
      }
      line.erase(line.find_last_not_of(' ') + 1);
      out += line + '\n';
    }
  }

 private:
  std::string title_;
  Cells labels_;
  std::size_t label_width_;
  std::vector<Cells> columns_{};
};

std::string decimals(double value, int digits, bool sign = false) {
  if (!std::isfinite(value)) return "-";
  std::string text = sign ? fmt::format("{:+.{}f}", value, digits) : fmt::format("{:.{}f}", value, digits);
  if (text.find_first_not_of("+-0.") == std::string::npos) text.erase(0, text.find('0'));  // no "-0.0"
  return text;
}

/// "345.2 ±3.1"; without an interval only the mean.
std::string with_interval(const Estimate& estimate) {
  if (!estimate.half_width) return decimals(estimate.mean, 1);
  return decimals(estimate.mean, 1) + " ±" + decimals(*estimate.half_width, 1);
}

/// Counts are whole in one run; a mean over runs may need a decimal.
std::string count_text(double mean) { return decimals(mean, mean == std::floor(mean) ? 0 : 1); }

/// "1 to 10", "1, 5, 7", and "1, 5, 7, ... 99" when they are many.
std::string seeds_text(const std::vector<std::uint64_t>& seeds) {
  if (seeds.size() > 2 && seeds.back() - seeds.front() == seeds.size() - 1 && std::ranges::is_sorted(seeds)) {
    return fmt::format("{} to {}", seeds.front(), seeds.back());
  }
  if (seeds.size() <= 8) return fmt::format("{}", fmt::join(seeds, ", "));
  return fmt::format("{}, {}, {}, ... {}", seeds[0], seeds[1], seeds[2], seeds.back());
}

bool is_sumo_arm(std::string_view name) {
  return name == "given" || name == "static" || name.starts_with("one-shot") || name.starts_with("device");
}

/// Names too long for a column get a number, and a line of their own below the heading.
struct Labels {
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

/// Breaks at blanks, so that no line goes beyond the width; later lines are indented.
std::string wrapped(std::string_view first, std::string_view text) {
  std::string out;
  std::string line(first);
  const std::string indent(width_of(first), ' ');
  bool fresh = true;
  while (!text.empty()) {
    const auto blank = text.find_first_of(" \n");
    const auto word = text.substr(0, blank);
    text.remove_prefix(blank == std::string_view::npos ? text.size() : blank + 1);
    if (word.empty()) continue;
    if (!fresh && width_of(line) + 1 + width_of(word) > line_width) {
      out += line + '\n';
      line = indent;
      fresh = true;
    }
    if (!fresh) line += ' ';
    line += word;
    fresh = false;
  }
  return out + line + '\n';
}

std::size_t succeeded(const Arm& arm) {
  return static_cast<std::size_t>(
      std::ranges::count_if(arm.runs, [](const RunSummary& run) { return !run.failed(); }));
}

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

std::vector<const Arm*> all_arms(const Comparison& comparison) {
  std::vector<const Arm*> arms;
  for (const Arm& arm : comparison.arms) arms.push_back(&arm);
  return arms;
}

void print_times(const Comparison& comparison, const Labels& labels, std::string& out) {
  const auto arms = all_arms(comparison);
  const auto mean = [&](double Group::*member, int digits) {
    return means_of(arms, digits, [&](const RunSummary& run) { return run.all.*member; });
  };
  TextTable table("Commute of all vehicles that were due; the rest of those that finished: means in s and m",
                  labels.of_arm, labels.width);
  table.column("commute", cells_of(arms, [](const Arm& arm) { return with_interval(commute(arm)); }));
  table.column("duration", mean(&Group::duration_mean, 1));
  table.column("depart delay", mean(&Group::depart_delay_mean, 1));
  table.column("time loss", mean(&Group::time_loss_mean, 1));
  table.column("route length", mean(&Group::route_length_mean, 0));
  table.column("runs", cells_of(arms, [](const Arm& arm) {
                 const std::size_t good = succeeded(arm);
                 return good == arm.runs.size() ? fmt::format("{}", good)
                                                : fmt::format("{} of {}", good, arm.runs.size());
               }));
  table.print(out);
}

void print_vehicles(const Comparison& comparison, const Labels& labels, std::string& out) {
  const auto arms = all_arms(comparison);
  const auto count = [&](std::uint64_t Group::*member) {
    return counts_of(arms, [&](const RunSummary& run) { return run.all.*member; });
  };
  TextTable table("Vehicles at the end of a run", labels.of_arm, labels.width);
  table.column("vehicles", count(&Group::vehicles));
  table.column("finished", count(&Group::finished));
  table.column("running", count(&Group::running));
  table.column("waiting", count(&Group::waiting));
  table.column("dropped", counts_of(arms, [](const RunSummary& run) { return run.dropped; }));
  table.column("discarded", count(&Group::discarded));
  table.column("not loaded", count(&Group::not_loaded));
  table.print(out);
}

void print_effort(const Comparison& comparison, const Labels& labels, std::string& out) {
  const auto arms = all_arms(comparison);
  const auto teleports = [&](std::uint64_t Teleports::*member) {
    return counts_of(arms, [&](const RunSummary& run) { return run.teleports.*member; });
  };
  TextTable table("Teleports by reason, re-routings, and CPU time in s, of a run", labels.of_arm,
                  labels.width);
  table.column("jam", teleports(&Teleports::jam));
  table.column("yield", teleports(&Teleports::yield));
  table.column("wrong lane", teleports(&Teleports::wrong_lane));
  table.column("collision", teleports(&Teleports::collision));
  table.column("re-routings", means_of(arms, 0, [](const RunSummary& run) { return run.reroutes; }));
  table.column("CPU router", cells_of(arms, [](const Arm& arm) -> std::string {
                 const double mean =
                     mean_over_runs(arm, [](const RunSummary& run) { return run.router_cpu_s; });
                 // SUMO's own routers work inside the simulation: their time cannot be told apart.
                 return mean == 0 && is_sumo_arm(arm.name) ? "-" : decimals(mean, 1);
               }));
  table.column("CPU simulation",
               means_of(arms, 1, [](const RunSummary& run) { return run.simulation_cpu_s; }));
  table.print(out);
}

void print_fixed(const Comparison& comparison, const Labels& labels, std::string& out) {
  std::vector<const Arm*> arms;
  Cells names;
  for (const Arm& arm : comparison.arms) {
    if (!(mean_over_runs(arm, [](const RunSummary& run) { return run.fixed.vehicles; }) > 0)) continue;
    arms.push_back(&arm);
    names.push_back(labels.find(comparison.arms, arm.name));
  }
  if (arms.empty()) return;
  const auto count = [&](std::uint64_t Group::*member) {
    return counts_of(arms, [&](const RunSummary& run) { return run.fixed.*member; });
  };
  const auto mean = [&](double Group::*member) {
    return means_of(arms, 1, [&](const RunSummary& run) { return run.fixed.*member; });
  };
  TextTable table("Fixed vehicles (buses and others that may not be re-routed), part of the above", names,
                  labels.width);
  table.column("commute", cells_of(arms, [](const Arm& arm) {
                 return with_interval(
                     estimate_over_runs(arm, [](const RunSummary& run) { return run.fixed.commute_mean; }));
               }));
  table.column("duration", mean(&Group::duration_mean));
  table.column("depart delay", mean(&Group::depart_delay_mean));
  table.column("vehicles", count(&Group::vehicles));
  table.column("finished", count(&Group::finished));
  table.print(out);
}

/// "-29.9 to -23.9", each times `unit`.
std::string range_text(const Estimate& estimate, double unit) {
  if (!estimate.half_width) return "-";
  return fmt::format("{} to {}", decimals(*estimate.low() * unit, 1, true),
                     decimals(*estimate.high() * unit, 1, true));
}

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

/// "static 12.5, evolved 3" for the arms where `value` is above 0 on average.
template <class Value>
std::string arms_with(const Comparison& comparison, const Labels& labels, Value value) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < comparison.arms.size(); ++i) {
    const double mean = mean_over_runs(comparison.arms[i], value);
    if (mean > 0) parts.push_back(fmt::format("{} {}", labels.of_arm[i], count_text(mean)));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

void print_warnings(const Comparison& comparison, const Labels& labels, std::string& out) {
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < comparison.arms.size(); ++i) {
    for (const RunSummary& run : comparison.arms[i].runs) {
      if (!run.failed()) continue;
      warnings.push_back(fmt::format("{}, seed {}, failed (exit {}) and is left out{}{}", labels.of_arm[i],
                                     run.seed, run.exit, run.error.empty() ? "." : ": ", run.error));
    }
  }
  if (comparison.seeds.size() == 1) {
    warnings.emplace_back(
        "One seed is one observation: there are no intervals, and no difference means anything yet.");
  }
  if (const auto arms =
          arms_with(comparison, labels, [](const RunSummary& run) { return run.teleports.total(); });
      !arms.empty()) {
    warnings.push_back(
        fmt::format("Vehicles were teleported ({} a run): a gain that needs teleports is no gain. "
                    "Compare again with `-- --time-to-teleport -1`.",
                    arms));
  }
  if (const auto arms = arms_with(comparison, labels,
                                  [](const RunSummary& run) { return run.all.running + run.all.waiting; });
      !arms.empty()) {
    warnings.push_back(
        fmt::format("Not all trips were finished at the end ({} a run): "
                    "these count until the end of the run.",
                    arms));
  }
  if (const auto arms =
          arms_with(comparison, labels, [](const RunSummary& run) { return run.all.discarded; });
      !arms.empty()) {
    warnings.push_back(
        fmt::format("SUMO discarded vehicles ({} a run): these count until the end of the run.", arms));
  }
  if (const auto arms = arms_with(comparison, labels, [](const RunSummary& run) { return run.unknown; });
      !arms.empty()) {
    warnings.push_back(fmt::format("Vehicles that the demand does not know were left out ({} a run).", arms));
  }
  if (warnings.empty()) return;
  out += '\n';
  for (const auto& warning : warnings) out += wrapped("Warning: ", warning);
}

}  // namespace

std::string format_table(const Comparison& comparison) {
  const Labels labels(comparison.arms);
  std::string_view sumo = comparison.sumo;  // libsumo says "SUMO 1.28.0"
  if (sumo.starts_with("SUMO ")) sumo.remove_prefix(5);
  std::string out = fmt::format("SUMO {} · {} {} · {} · Thalweg {}\n", sumo,
                                comparison.seeds.size() == 1 ? "seed" : "seeds", seeds_text(comparison.seeds),
                                comparison.configuration, comparison.thalweg);
  out += labels.legend;
  print_times(comparison, labels, out);
  print_vehicles(comparison, labels, out);
  print_effort(comparison, labels, out);
  print_fixed(comparison, labels, out);
  print_differences(comparison, labels, out);
  print_warnings(comparison, labels, out);
  return out;
}

}  // namespace thalweg
