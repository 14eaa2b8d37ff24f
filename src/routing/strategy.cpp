// SPDX-License-Identifier: Apache-2.0
#include "routing/strategy.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/error.hpp"
#include "core/nearest.hpp"
#include "routing/list.hpp"

namespace thalweg {

bool ChoiceRule::prefers(const Traveller& traveller, Millis old_cost, Millis new_cost) const {
  if (new_cost >= old_cost) return false;
  if (old_cost >= infinity) return true;  // its way is broken: any other is better
  return old_cost - new_cost > threshold(traveller, old_cost);
}

Millis ChoiceRule::threshold(const Traveller& traveller, Millis old_cost) const {
  const double share = caution + (traveller.departed ? relative : 0) + spread * traveller.patience;
  return static_cast<Millis>(std::floor(share * static_cast<double>(old_cost))) + absolute;
}

std::span<const StrategyEntry> strategies() {
  static constexpr std::array<StrategyEntry, 8> list{{
      {"hybrid", "fewest turns, then least time (the paper's hybrid algorithm)", &make_hybrid},
      {"evolved", "the hybrid's tree evolved to the optimum (the paper's evolutionary hybrid)",
       &make_evolved},
      {"forecast",
       "least time by a forecast of where the queues will be, and a part of what a vehicle costs the others",
       &make_forecast, true},
      {"booking",
       "by a vehicle's own time alone, and who decides sees what those before it have decided (the paper's "
       "reserve table)",
       &make_booking, true},
      {"marginal",
       "the forecast with a toll of 1: all of the delay that a vehicle costs the others counts as its own",
       &make_marginal, true},
      {"memory", "the forecast with what the days before have taught (the paper's crew)", &make_memory, true},
      {"cch", "the same optimum by a customizable contraction hierarchy: fast on large nets", &make_cch},
      {"dijkstra", "least time by Dijkstra's algorithm, to compare with", &make_dijkstra},
  }};
  return list;
}

std::unique_ptr<Strategy> make_strategy(std::string_view name, const StrategyOptions& options) {
  std::vector<std::string> names;
  for (const auto& entry : strategies()) {
    if (entry.name == name) return entry.make(options);
    names.emplace_back(entry.name);
  }
  throw InputError(fmt::format("there is no strategy '{}'{}; there are: {}", name, did_you_mean(name, names),
                               fmt::join(names, ", ")));
}

Millis route_cost(const ClassTraffic& traffic, std::span<const VertexId> route) {
  const Digraph& turns = traffic.graph->turns();
  Millis cost = route.empty() ? infinity : traffic.road_times[traffic.graph->road(route.back())];
  for (std::size_t i = 0; i + 1 < route.size(); ++i) {
    Millis turn = infinity;
    for (const Arc& arc : turns.out(route[i])) {
      if (arc.end == route[i + 1]) turn = std::min(turn, traffic.turn_costs[arc.id.value]);
    }
    cost = add_saturating(cost, turn);
  }
  return cost;
}

}  // namespace thalweg
