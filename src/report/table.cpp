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

/// Rows of cells: the first column to the left, the others to the right.
class TextTable {
 public:
  TextTable(std::string title, std::vector<std::string> head) : title_(std::move(title)) {
    rows_.push_back(std::move(head));
  }

  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

  void print(std::string& out, std::size_t first_width) const {
    if (rows_.size() < 2) return;
    std::vector<std::size_t> widths(rows_.front().size(), 0);
    widths.front() = first_width;
    for (const auto& row : rows_) {
      for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
    }
    out += fmt::format("\n{}\n", title_);
    for (const auto& row : rows_) {
      std::string line = "  " + row.front() + std::string(widths.front() - width_of(row.front()), ' ');
      for (std::size_t i = 1; i < row.size(); ++i) {
        line += "  " + std::string(widths[i] - width_of(row[i]), ' ') + row[i];
      }
      line.erase(line.find_last_not_of(' ') + 1);
      out += line + '\n';
    }
  }

 private:
  std::string title_;
  std::vector<std::vector<std::string>> rows_;
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

void print_times(const Comparison& comparison, const Labels& labels, std::string& out) {
  TextTable table("A trip, on average, in s (± 95 % over seeds) and m",
                  {"", "commute", "duration", "depart delay", "time loss", "route length", "runs"});
  for (std::size_t i = 0; i < comparison.arms.size(); ++i) {
    const Arm& arm = comparison.arms[i];
    const auto mean = [&](double Group::*member) {
      return mean_over_runs(arm, [&](const RunSummary& run) { return run.all.*member; });
    };
    const std::size_t good = succeeded(arm);
    table.add(
        {labels.of_arm[i], with_interval(commute(arm)), decimals(mean(&Group::duration_mean), 1),
         decimals(mean(&Group::depart_delay_mean), 1), decimals(mean(&Group::time_loss_mean), 1),
         decimals(mean(&Group::route_length_mean), 0),
         good == arm.runs.size() ? fmt::format("{}", good) : fmt::format("{} of {}", good, arm.runs.size())});
  }
  table.print(out, labels.width);
}

void print_vehicles(const Comparison& comparison, const Labels& labels, std::string& out) {
  TextTable table("Vehicles at the end of a run",
                  {"", "vehicles", "finished", "running", "waiting", "dropped", "discarded", "not loaded"});
  for (std::size_t i = 0; i < comparison.arms.size(); ++i) {
    const Arm& arm = comparison.arms[i];
    const auto mean = [&](std::uint64_t Group::*member) {
      return count_text(mean_over_runs(arm, [&](const RunSummary& run) { return run.all.*member; }));
    };
    table.add({labels.of_arm[i], mean(&Group::vehicles), mean(&Group::finished), mean(&Group::running),
               mean(&Group::waiting),
               count_text(mean_over_runs(arm, [](const RunSummary& run) { return run.dropped; })),
               mean(&Group::discarded), mean(&Group::not_loaded)});
  }
  table.print(out, labels.width);
}

void print_effort(const Comparison& comparison, const Labels& labels, std::string& out) {
  TextTable table(
      "Teleports by reason, re-routings, CPU time in s, of a run",
      {"", "jam", "yield", "wrong lane", "collision", "re-routings", "CPU router", "CPU simulation"});
  for (std::size_t i = 0; i < comparison.arms.size(); ++i) {
    const Arm& arm = comparison.arms[i];
    const auto teleports = [&](std::uint64_t Teleports::*member) {
      return count_text(mean_over_runs(arm, [&](const RunSummary& run) { return run.teleports.*member; }));
    };
    const double router = mean_over_runs(arm, [](const RunSummary& run) { return run.router_cpu_s; });
    // SUMO's own routers work inside the simulation: their time cannot be told apart.
    const bool inside = router == 0 && is_sumo_arm(arm.name);
    table.add({labels.of_arm[i], teleports(&Teleports::jam), teleports(&Teleports::yield),
               teleports(&Teleports::wrong_lane), teleports(&Teleports::collision),
               decimals(mean_over_runs(arm, [](const RunSummary& run) { return run.reroutes; }), 0),
               inside ? "-" : decimals(router, 1),
               decimals(mean_over_runs(arm, [](const RunSummary& run) { return run.simulation_cpu_s; }), 1)});
  }
  table.print(out, labels.width);
}

void print_fixed(const Comparison& comparison, const Labels& labels, std::string& out) {
  TextTable table("Fixed vehicles (buses and others that may not be re-routed), part of the above",
                  {"", "vehicles", "finished", "commute", "duration", "depart delay"});
  for (std::size_t i = 0; i < comparison.arms.size(); ++i) {
    const Arm& arm = comparison.arms[i];
    const auto of_fixed = [&](auto member) {
      return estimate_over_runs(arm, [&](const RunSummary& run) { return run.fixed.*member; });
    };
    if (!(of_fixed(&Group::vehicles).mean > 0)) continue;
    table.add({labels.of_arm[i], count_text(of_fixed(&Group::vehicles).mean),
               count_text(of_fixed(&Group::finished).mean), with_interval(of_fixed(&Group::commute_mean)),
               decimals(of_fixed(&Group::duration_mean).mean, 1),
               decimals(of_fixed(&Group::depart_delay_mean).mean, 1)});
  }
  table.print(out, labels.width);
}

void print_differences(const Comparison& comparison, const Labels& labels, std::string& out) {
  const auto all = differences(comparison);
  bool marked = false;
  for (const char* baseline : baselines) {
    TextTable table(fmt::format("Mean commute less that of {}, seed by seed", baseline),
                    {"", "s", "95 %", "percent", "95 %", "", "correlation", "more seeds for ±1 %"});
    for (const Difference& difference : all) {
      if (difference.baseline != baseline) continue;
      const Estimate& paired = difference.paired;
      const double percent = 100 / difference.baseline_mean;
      const auto interval = [&](double unit, int digits) -> std::string {
        if (!paired.half_width) return "-";
        return fmt::format("{} to {}", decimals(*paired.low() * unit, digits, true),
                           decimals(*paired.high() * unit, digits, true));
      };
      marked = marked || paired.differs_from_zero();
      table.add({labels.find(comparison.arms, difference.arm), decimals(paired.mean, 1, true), interval(1, 1),
                 decimals(paired.mean * percent, 1, true), interval(percent, 1),
                 paired.differs_from_zero() ? "*" : "",
                 difference.correlation ? decimals(*difference.correlation, 2, true) : "-",
                 difference.more_seeds ? fmt::format("{}", *difference.more_seeds) : "-"});
    }
    table.print(out, labels.width);
  }
  if (marked) out += "  * the interval does not contain 0\n";
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
