// SPDX-License-Identifier: Apache-2.0
#include "report/days.hpp"

#include <fmt/format.h>

#include <fstream>

#include "core/error.hpp"
#include "report/comparison.hpp"
#include "report/text_table.hpp"

namespace thalweg {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void write_json(const Days& days, const std::filesystem::path& file) {
  Json entries = Json::array();
  for (std::size_t i = 0; i < days.days.size(); ++i) {
    Json entry{{"day", i + 1}};
    entry.update(to_json(days.days[i]));
    entries.push_back(std::move(entry));
  }
  const Json json{{"thalweg", days.thalweg}, {"sumo", days.sumo}, {"configuration", days.configuration},
                  {"command", days.command}, {"run", days.run},   {"days", std::move(entries)}};
  write_json(json, file);
}

Days read_days(const std::filesystem::path& file) {
  std::ifstream stream(file);
  verify(static_cast<bool>(stream), fmt::format("cannot read '{}'", file.string()));
  try {
    const Json json = Json::parse(stream);
    Days days;
    json.at("thalweg").get_to(days.thalweg);
    json.at("sumo").get_to(days.sumo);
    json.at("configuration").get_to(days.configuration);
    json.at("command").get_to(days.command);
    json.at("run").get_to(days.run);
    for (const Json& entry : json.at("days")) days.days.push_back(run_from_json(entry));
    return days;
  } catch (const std::exception& error) {
    throw InputError(fmt::format("'{}' is no days.json: {}", file.string(), error.what()));
  }
}

std::string format_table(const Days& days) {
  std::string text = fmt::format(
      "{} · {} · Thalweg {}\n\nDay by day: mean commute of all vehicles that were "
      "due in s, teleports, re-routings, CPU time in s\n",
      days.sumo, days.configuration, days.thalweg);  // libsumo says "SUMO 1.28.0"
  const auto line = [&](auto... cells) {
    text += fmt::format("  {:>4}  {:>10}  {:>9}  {:>9}  {:>10}  {:>10}  {:>10}  {:>14}\n", cells...);
  };
  line("day", "seed", "commute", "finished", "teleports", "re-routings", "CPU router", "CPU simulation");
  for (std::size_t i = 0; i < days.days.size(); ++i) {
    const RunSummary& day = days.days[i];
    if (day.failed()) {
      text += fmt::format("  {:>4}  {:>10}  failed: {}\n", i + 1, day.seed, day.error);
      continue;
    }
    line(i + 1, day.seed, decimals(day.all.commute_mean, 1), day.all.finished, day.teleports.total(),
         day.reroutes, decimals(day.router_cpu_s, 1), decimals(day.simulation_cpu_s, 1));
  }
  return text;
}

}  // namespace thalweg
