// SPDX-License-Identifier: Apache-2.0
#include "lab/memory_crew.hpp"

#include <cassert>

namespace thalweg::lab {

MemoryCrew::MemoryCrew(const Digraph& graph, std::vector<Errand> errands, const std::vector<Millis>& expected,
                       Memory memory)
    : graph_(graph), memory_(memory) {
  minds_.assign(memory == Memory::own ? errands.size() : 1, Mind{.belief = expected});
  for (const Errand& errand : errands) {
    Vehicle& vehicle = vehicles_.emplace_back();
    vehicle.errand = errand;
    partition<Direction::backward>(graph, {&errand.target, 1}, vehicle.regions);
  }
}

ArcId MemoryCrew::next_road(std::size_t vehicle) {
  auto& [errand, at, regions, plan, planned_by] = vehicles_[vehicle];
  const Mind& mind = mind_of(vehicle);
  if (planned_by != mind.version) {
    const auto cost = [&mind](ArcId arc) { return mind.belief[arc.value]; };
    hybrid<Direction::backward>(graph_, regions, cost, plan);
    evolve<Direction::backward>(graph_, regions, cost, plan, scratch_);
    planned_by = mind.version;
  }
  assert(plan.parent[at].valid());
  return plan.parent[at];
}

// It ends: between two changes of belief a plan is followed without meeting a vertex twice, and each time
// that a vehicle goes in a circle the roads of it are known better or have become dearer, the way out has
// not.
Millis MemoryCrew::drive(std::span<const Millis> today, Millis per_vehicle) {
  std::vector<Millis> driven(graph_.arc_count(), 0);
  for (Vehicle& vehicle : vehicles_) vehicle.at = vehicle.errand.source;
  Millis sum = 0;
  for (bool moving = true; moving;) {
    moving = false;
    for (std::size_t i = 0; i < vehicles_.size(); ++i) {
      Vehicle& vehicle = vehicles_[i];
      if (vehicle.at == vehicle.errand.target) continue;
      const ArcId road = next_road(i);
      const Millis met = today[road.value] + per_vehicle * driven[road.value]++;
      sum += met;
      vehicle.at = graph_.ends(road).head;
      moving = true;
      if (memory_ == Memory::none) continue;
      Mind& mind = mind_of(i);
      if (mind.belief[road.value] == met) continue;
      mind.belief[road.value] = met;
      ++mind.version;
    }
  }
  return sum;
}

}  // namespace thalweg::lab
