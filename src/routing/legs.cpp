// SPDX-License-Identifier: Apache-2.0
#include "routing/legs.hpp"

#include <algorithm>
#include <tuple>

namespace thalweg {
namespace {

void join(const ClassTraffic& seen, const Traveller& traveller, std::span<const Leg> legs,
          const ChoiceRule& rule, Decision& decision) {
  decision.old_cost = route_cost(seen, traveller.route);
  decision.new_cost = infinity;
  if (legs.empty()) return;
  Millis cost = seen.road_times[seen.graph->road(legs.back().destination)];
  for (const Leg& leg : legs) cost = add_saturating(cost, leg.cost);
  if (cost >= infinity) return;
  decision.new_cost = cost;
  decision.route.push_back(traveller.route.front());
  for (const Leg& leg : legs) decision.route.insert(decision.route.end(), leg.roads.begin(), leg.roads.end());
  decision.change =
      decision.route != traveller.route && rule.prefers(traveller, decision.old_cost, decision.new_cost);
}

}  // namespace

void Legs::collect(std::span<const Traveller> due) {
  legs_.clear();
  for (std::size_t i = 0; i < due.size(); ++i) {
    VertexId origin = due[i].route.front();
    for (std::size_t k = 0; k < due[i].waypoints.size(); ++k) {
      legs_.push_back({.vehicle_class = due[i].vehicle_class,
                       .destination = due[i].waypoints[k],
                       .origin = origin,
                       .traveller = i,
                       .number = k});
      origin = due[i].waypoints[k];
    }
  }
  std::sort(legs_.begin(), legs_.end(), [](const Leg& a, const Leg& b) {
    return std::tie(a.vehicle_class, a.destination, a.traveller, a.number) <
           std::tie(b.vehicle_class, b.destination, b.traveller, b.number);
  });
  first_.clear();
  for (std::size_t i = 0; i < legs_.size(); ++i) {
    const bool same = i > 0 && legs_[i].vehicle_class == legs_[i - 1].vehicle_class &&
                      legs_[i].destination == legs_[i - 1].destination;
    if (!same) first_.push_back(i);
  }
  first_.push_back(legs_.size());
}

void Legs::decide(std::span<const ClassTraffic> traffic, std::span<const Traveller> due,
                  const ChoiceRule& rule, std::vector<Decision>& decisions) {
  std::sort(legs_.begin(), legs_.end(), [](const Leg& a, const Leg& b) {
    return std::tie(a.traveller, a.number) < std::tie(b.traveller, b.number);
  });
  decisions.assign(due.size(), {});
  std::size_t leg = 0;
  for (std::size_t i = 0; i < due.size(); ++i) {
    const std::size_t first = leg;
    while (leg < legs_.size() && legs_[leg].traveller == i) ++leg;
    join(traffic[due[i].vehicle_class], due[i], std::span(legs_).subspan(first, leg - first), rule,
         decisions[i]);
  }
}

}  // namespace thalweg
