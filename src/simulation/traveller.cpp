// SPDX-License-Identifier: Apache-2.0
#include "simulation/traveller.hpp"

#include <algorithm>

#include "core/hash.hpp"
#include "simulation/kept_positions.hpp"

namespace thalweg {

std::optional<Traveller> make_traveller(const Plan& plan, const DemandVehicle& wanted,
                                        const RoadGraph& graph) {
  Traveller result;
  result.patience = unit_hash(wanted.id);
  result.driven = plan.committed == 1 ? plan.driven : 0;
  const std::size_t first = plan.committed - 1;
  for (std::size_t i = first; i < plan.route.size(); ++i) {
    const VertexId vertex = graph.vertex(plan.route[i]);
    if (!vertex.valid()) return {};
    result.route.push_back(vertex);
  }
  VertexId last = result.route.front();
  for (const std::size_t position : kept_positions(plan, wanted.via)) {
    if (position <= first || result.route[position - first] == last) continue;
    last = result.route[position - first];
    result.waypoints.push_back(last);
  }
  if (result.waypoints.empty()) return {};
  return result;
}

Millis until_free_turn(const Plan& plan, Millis until_depart, const RoadTimes& times) {
  const Millis behind = static_cast<Millis>(
      plan.driven * static_cast<double>(std::min(times[plan.route.front()], infinity / 4)));
  Millis ahead = 0;
  for (std::size_t k = 0; k + 1 < plan.committed; ++k) ahead = add_saturating(ahead, times[plan.route[k]]);
  return until_depart + ahead - behind;
}

}  // namespace thalweg
