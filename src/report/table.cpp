// SPDX-License-Identifier: Apache-2.0
#include "report/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "report/table_sections.hpp"

namespace thalweg {
namespace {

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

std::size_t succeeded(const Arm& arm) {
  return static_cast<std::size_t>(
      std::ranges::count_if(arm.runs, [](const RunSummary& run) { return !run.failed(); }));
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

/// Some of the vehicles by themselves; nothing when no arm has any.
void print_group(const Comparison& comparison, const Labels& labels, Group RunSummary::*group,
                 std::string title, std::string& out) {
  std::vector<const Arm*> arms;
  Cells names;
  for (const Arm& arm : comparison.arms) {
    if (!(mean_over_runs(arm, [&](const RunSummary& run) { return (run.*group).vehicles; }) > 0)) continue;
    arms.push_back(&arm);
    names.push_back(labels.find(comparison.arms, arm.name));
  }
  if (arms.empty()) return;
  const auto count = [&](std::uint64_t Group::*member) {
    return counts_of(arms, [&](const RunSummary& run) { return (run.*group).*member; });
  };
  const auto mean = [&](double Group::*member) {
    return means_of(arms, 1, [&](const RunSummary& run) { return (run.*group).*member; });
  };
  TextTable table(std::move(title), names, labels.width);
  table.column("commute", cells_of(arms, [&](const Arm& arm) {
                 return with_interval(estimate_over_runs(
                     arm, [&](const RunSummary& run) { return (run.*group).commute_mean; }));
               }));
  table.column("duration", mean(&Group::duration_mean));
  table.column("depart delay", mean(&Group::depart_delay_mean));
  table.column("vehicles", count(&Group::vehicles));
  table.column("finished", count(&Group::finished));
  table.print(out);
}

/// Where only a share of the vehicles is ours.
void print_equipped(const Comparison& comparison, const Labels& labels, std::string& out) {
  const bool is_shared = std::ranges::any_of(comparison.arms, [](const Arm& arm) {
    return std::ranges::any_of(arm.runs, [](const RunSummary& run) { return run.unequipped.vehicles > 0; });
  });
  if (!is_shared) return;
  print_group(comparison, labels, &RunSummary::equipped,
              "Equipped vehicles: the share that a router of ours leads; the same vehicles in every arm",
              out);
  print_group(comparison, labels, &RunSummary::unequipped, "The others, without the fixed ones", out);
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
      if (run.error == was_interrupted) {
        warnings.push_back(
            fmt::format("{}, seed {}, was interrupted and is left out.", labels.of_arm[i], run.seed));
        continue;
      }
      warnings.push_back(fmt::format("{}, seed {}, failed (exit {}) and is left out{}{}", labels.of_arm[i],
                                     run.seed, run.exit, run.error.empty() ? "." : ": ", run.error));
    }
  }
  if (comparison.seeds.size() == 1) {
    warnings.emplace_back(
        "One seed is one observation: there are no intervals, and no difference means anything yet.");
  }
  if (const auto arms =
          arms_with(comparison, labels, [](const RunSummary& run) { return run.teleports.stuck(); });
      !arms.empty()) {
    warnings.push_back(
        fmt::format("Vehicles were teleported ({} a run): a gain that needs teleports is no gain. "
                    "Compare again with `-- --time-to-teleport -1`.",
                    arms));
  }
  if (const auto arms =
          arms_with(comparison, labels, [](const RunSummary& run) { return run.teleports.collision; });
      !arms.empty()) {
    warnings.push_back(
        fmt::format("Vehicles were teleported after collisions ({} a run). "
                    "Compare again with `-- --collision.action warn`.",
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
    warnings.push_back(
        fmt::format("Vehicles that are not of the demand ({} a run; calibrators insert some, or a state) are "
                    "in no figure, and not re-routed by Thalweg.",
                    arms));
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
  print_group(comparison, labels, &RunSummary::fixed,
              "Fixed vehicles (buses and others that may not be re-routed), part of the above", out);
  print_equipped(comparison, labels, out);
  print_gaps(comparison, labels, out);
  print_forecast_errors(comparison, labels, out);
  print_differences(comparison, labels, out);
  print_warnings(comparison, labels, out);
  return out;
}

}  // namespace thalweg
