// SPDX-License-Identifier: Apache-2.0
#include "report/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "core/error.hpp"
#include "xml/writer.hpp"

namespace thalweg {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

template <class T>
Json number(const std::optional<T>& value) {
  if (!value) return nullptr;
  if constexpr (std::is_floating_point_v<T>) return number(*value);
  return *value;
}

Json interval_of(const Estimate& estimate) {
  return {
      {"mean", number(estimate.mean)}, {"low", number(estimate.low())}, {"high", number(estimate.high())}};
}

double read_number(const Json& json, const char* key) {
  const Json& value = json.at(key);
  return value.is_null() ? no_value : value.get<double>();
}

Json group_to_json(const Group& group) {
  return {{"vehicles", group.vehicles},
          {"finished", group.finished},
          {"running", group.running},
          {"waiting", group.waiting},
          {"discarded", group.discarded},
          {"not_loaded", group.not_loaded},
          {"commute_mean", number(group.commute_mean)},
          {"duration_mean", number(group.duration_mean)},
          {"depart_delay_mean", number(group.depart_delay_mean)},
          {"time_loss_mean", number(group.time_loss_mean)},
          {"route_length_mean", number(group.route_length_mean)}};
}

/// A run has its group's keys among its own.
Group group_from_json(const Json& json) {
  Group group;
  json.at("vehicles").get_to(group.vehicles);
  json.at("finished").get_to(group.finished);
  json.at("running").get_to(group.running);
  json.at("waiting").get_to(group.waiting);
  json.at("discarded").get_to(group.discarded);
  json.at("not_loaded").get_to(group.not_loaded);
  group.commute_mean = read_number(json, "commute_mean");
  group.duration_mean = read_number(json, "duration_mean");
  group.depart_delay_mean = read_number(json, "depart_delay_mean");
  group.time_loss_mean = read_number(json, "time_loss_mean");
  group.route_length_mean = read_number(json, "route_length_mean");
  return group;
}

/// Means in s; sums are what a reader makes of them again.
Json errors_to_json(const ForecastError& errors) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const HorizonError& error = errors[i];
    rows.push_back({{"from_s", number(to_seconds(horizons[i]))},
                    {"predictions", error.predictions},
                    {"realised_mean", number(error.mean(error.realised))},
                    {"mean_absolute_error", number(error.mean(error.own.absolute))},
                    {"bias", number(error.mean(error.own.difference))},
                    {"measured_mean_absolute_error", number(error.mean(error.measured.absolute))},
                    {"measured_bias", number(error.mean(error.measured.difference))}});
  }
  return rows;
}

ForecastError errors_from_json(const Json& rows) {
  ForecastError errors;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const Json& row = rows.at(i);
    HorizonError& error = errors[i];
    row.at("predictions").get_to(error.predictions);
    if (error.predictions == 0) continue;
    const auto sum = [&](const char* key) {
      return read_number(row, key) * static_cast<double>(error.predictions);
    };
    error.realised = sum("realised_mean");
    error.own = {.absolute = sum("mean_absolute_error"), .difference = sum("bias")};
    error.measured = {.absolute = sum("measured_mean_absolute_error"), .difference = sum("measured_bias")};
  }
  return errors;
}

Json gap_to_json(const RelativeGap& gap) {
  return {{"trips", gap.trips},           {"own_s", number(gap.own_s)},
          {"best_s", number(gap.best_s)}, {"relative_gap", number(gap.relative())},
          {"gaining", gap.gaining},       {"gaining_share", number(gap.gaining_share())}};
}

RelativeGap gap_from_json(const Json& json) {
  RelativeGap gap;
  json.at("trips").get_to(gap.trips);
  json.at("gaining").get_to(gap.gaining);
  gap.own_s = read_number(json, "own_s");
  gap.best_s = read_number(json, "best_s");
  return gap;
}

Json run_entry(const RunSummary& run) {
  return {{"seed", run.seed},
          {"vehicles", run.all.vehicles},
          {"finished", run.all.finished},
          {"running", run.all.running},
          {"waiting", run.all.waiting},
          {"dropped", run.dropped},
          {"discarded", run.all.discarded},
          {"not_loaded", run.all.not_loaded},
          {"commute_mean", number(run.all.commute_mean)},
          {"duration_mean", number(run.all.duration_mean)},
          {"depart_delay_mean", number(run.all.depart_delay_mean)},
          {"time_loss_mean", number(run.all.time_loss_mean)},
          {"route_length_mean", number(run.all.route_length_mean)},
          {"teleports",
           {{"jam", run.teleports.jam},
            {"yield", run.teleports.yield},
            {"wrong_lane", run.teleports.wrong_lane},
            {"collision", run.teleports.collision}}},
          {"reroutes", run.reroutes},
          {"ignored", run.ignored},
          {"fixed", group_to_json(run.fixed)},
          {"equipped", group_to_json(run.equipped)},
          {"unequipped", group_to_json(run.unequipped)},
          {"equilibrium", gap_to_json(run.gap)},
          {"forecast_error", errors_to_json(run.forecast_error)},
          {"unknown", run.unknown},
          {"end_s", number(run.end_s)},
          {"wall_s", number(run.wall_s)},
          {"router_cpu_s", number(run.router_cpu_s)},
          {"simulation_cpu_s", number(run.simulation_cpu_s)},
          {"exit", run.exit},
          {"error", run.error.empty() ? Json(nullptr) : Json(run.error)}};
}

const RunSummary* find_success(const Arm& arm, std::uint64_t seed) {
  const auto found = std::ranges::find_if(arm.runs, [&](const RunSummary& run) {
    return run.seed == seed && !run.failed() && std::isfinite(run.all.commute_mean);
  });
  return found == arm.runs.end() ? nullptr : &*found;
}

std::optional<Difference> difference_of(const Arm& arm, const Arm& baseline) {
  std::vector<double> own;
  std::vector<double> others;
  std::vector<double> pairs;
  for (const RunSummary& run : arm.runs) {
    const RunSummary* other = find_success(baseline, run.seed);
    if (other == nullptr || find_success(arm, run.seed) != &run) continue;
    own.push_back(run.all.commute_mean);
    others.push_back(other->all.commute_mean);
    pairs.push_back(own.back() - others.back());
  }
  if (own.empty()) return std::nullopt;
  Difference difference{.arm = arm.name, .baseline = baseline.name};
  difference.paired = paired_difference(own, others);
  difference.welch = welch_difference(own, others);
  difference.baseline_mean = estimate(others).mean;
  difference.correlation = correlation(own, others);
  difference.more_seeds = more_values_needed(pairs, 0.01 * std::abs(difference.baseline_mean));
  return difference;
}

}  // namespace

void write_json(const Json& json, const std::filesystem::path& file) {
  OutputFile output(file);
  output.write(json.dump(2, ' ', false, Json::error_handler_t::replace));
  output.write("\n");
  output.commit();
}

Estimate commute(const Arm& arm) {
  return estimate_over_runs(arm, [](const RunSummary& run) { return run.all.commute_mean; });
}

std::vector<Difference> differences(const Comparison& comparison) {
  std::vector<Difference> result;
  for (const Arm& arm : comparison.arms) {
    for (const char* name : baselines) {
      const auto baseline = std::ranges::find(comparison.arms, name, &Arm::name);
      if (baseline == comparison.arms.end() || arm.name == name) continue;
      if (auto difference = difference_of(arm, *baseline)) result.push_back(std::move(*difference));
    }
  }
  return result;
}

nlohmann::ordered_json to_json(const Comparison& comparison) {
  Json arms = Json::array();
  for (const Arm& arm : comparison.arms) {
    Json runs = Json::array();
    for (const RunSummary& run : arm.runs) runs.push_back(run_entry(run));
    arms.push_back({{"name", arm.name}, {"commute", interval_of(commute(arm))}, {"runs", std::move(runs)}});
  }
  Json rows = Json::array();
  for (const Difference& difference : differences(comparison)) {
    rows.push_back({{"arm", difference.arm},
                    {"baseline", difference.baseline},
                    {"mean", number(difference.paired.mean)},
                    {"low", number(difference.paired.low())},
                    {"high", number(difference.paired.high())},
                    {"relative", number(difference.relative())},
                    {"seeds", difference.paired.count},
                    {"welch", interval_of(difference.welch)},
                    {"correlation", number(difference.correlation)},
                    {"more_seeds", number(difference.more_seeds)}});
  }
  return {{"thalweg", comparison.thalweg},
          {"sumo", comparison.sumo},
          {"configuration", comparison.configuration},
          {"command", comparison.command},
          {"seeds", comparison.seeds},
          {"arms", std::move(arms)},
          {"differences", std::move(rows)}};
}

void write_json(const Comparison& comparison, const std::filesystem::path& file) {
  write_json(to_json(comparison), file);
}

nlohmann::ordered_json to_json(const RunSummary& run) {
  Json json{{"arm", run.arm}};
  json.update(run_entry(run));
  return json;
}

RunSummary run_from_json(const nlohmann::ordered_json& json) {
  try {
    RunSummary run;
    json.at("arm").get_to(run.arm);
    json.at("seed").get_to(run.seed);
    run.all = group_from_json(json);
    run.fixed = group_from_json(json.at("fixed"));
    run.equipped = group_from_json(json.at("equipped"));
    run.unequipped = group_from_json(json.at("unequipped"));
    json.at("ignored").get_to(run.ignored);
    run.gap = gap_from_json(json.at("equilibrium"));
    run.forecast_error = errors_from_json(json.at("forecast_error"));
    json.at("dropped").get_to(run.dropped);
    json.at("unknown").get_to(run.unknown);
    const Json& teleports = json.at("teleports");
    teleports.at("jam").get_to(run.teleports.jam);
    teleports.at("yield").get_to(run.teleports.yield);
    teleports.at("wrong_lane").get_to(run.teleports.wrong_lane);
    teleports.at("collision").get_to(run.teleports.collision);
    json.at("reroutes").get_to(run.reroutes);
    run.end_s = read_number(json, "end_s");
    run.wall_s = read_number(json, "wall_s");
    run.router_cpu_s = read_number(json, "router_cpu_s");
    run.simulation_cpu_s = read_number(json, "simulation_cpu_s");
    json.at("exit").get_to(run.exit);
    if (const Json& error = json.at("error"); !error.is_null()) error.get_to(run.error);
    return run;
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("this is no run.json: {}", error.what()));
  }
}

void write_json(const RunSummary& run, const std::filesystem::path& file) { write_json(to_json(run), file); }

RunSummary read_run(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(fmt::format("cannot read '{}'", file.string()));
  try {
    return run_from_json(Json::parse(stream));
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("{}: this is no JSON: {}", file.string(), error.what()));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

}  // namespace thalweg
