// SPDX-License-Identifier: Apache-2.0
#include "report/decisions.hpp"

namespace thalweg {
namespace {

std::string names_of(const Network& network, const std::vector<RoadId>& route) {
  std::string names;
  for (const RoadId road : route) {
    if (!names.empty()) names += ' ';
    names += network.roads[road].id;
  }
  return names;
}

std::string time_or_none(Millis t) { return t >= infinity ? "-1" : format_seconds(t); }

}  // namespace

DecisionOutput::DecisionOutput(const std::filesystem::path& file, std::string_view header)
    : writer_(file, header) {
  writer_.open("decisions");
}

void DecisionOutput::write(const Network& network, const Demand& demand, const RunResult& result) {
  for (const LoggedDecision& decision : result.log) {
    writer_.open("decision")
        .attribute("time", format_seconds(decision.time))
        .attribute("vehicle", demand.vehicles[decision.vehicle].id)
        .attribute("changed", decision.new_route.empty() ? "false" : "true")
        .attribute("oldCost", time_or_none(decision.old_cost))
        .attribute("newCost", time_or_none(decision.new_cost))
        .attribute("predictedArrival", time_or_none(decision.predicted_arrival))
        .attribute("arrival", time_or_none(result.arrival[decision.vehicle]))
        .attribute("oldRoute", names_of(network, decision.old_route));
    if (!decision.new_route.empty()) writer_.attribute("newRoute", names_of(network, decision.new_route));
    writer_.close();
  }
  writer_.commit();
}

}  // namespace thalweg
