// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/time.hpp"
#include "graph/digraph.hpp"
#include "lab/crew.hpp"
#include "search/evolve.hpp"
#include "search/hybrid.hpp"

namespace thalweg::lab {

/// What a vehicle routes by: what it expected on the first day, what it met itself since then, or what
/// anybody of its crew met.
enum class Memory : std::uint8_t { none, own, shared };

/// The paper's first application: vehicles that drive their errands day after day, record what each road cost
/// them, plan by that memory, and plan again before every road. Of a road that nobody who tells them has
/// driven they believe what was expected; of the others, the last that was met.
class MemoryCrew {
 public:
  /// `graph` must outlive the crew. `expected`: cost of every arc, all above 0; the errands must be possible.
  MemoryCrew(const Digraph& graph, std::vector<Errand> errands, const std::vector<Millis>& expected,
             Memory memory);

  /// A day: in turn, each vehicle drives one road, until all are at their targets. A road costs `today`, and
  /// `per_vehicle` more for each time that the crew has driven it before on this day. What is met is known to
  /// those who share it before the next vehicle moves. The sum of what all ways cost.
  Millis drive(std::span<const Millis> today, Millis per_vehicle);

 private:
  struct Mind {
    std::vector<Millis> belief;
    std::uint64_t version = 1;  ///< one more with each change of belief
  };
  struct Vehicle {
    Errand errand;
    VertexId at;
    Regions regions;  ///< against the arcs, from the target: they never change
    Tree plan;
    std::uint64_t planned_by = 0;  ///< version of the mind; 0: not planned yet
  };
  Mind& mind_of(std::size_t vehicle) { return minds_[minds_.size() == 1 ? 0 : vehicle]; }
  ArcId next_road(std::size_t vehicle);

  const Digraph& graph_;
  Memory memory_;
  std::vector<Mind> minds_;
  std::vector<Vehicle> vehicles_;
  EvolveScratch scratch_;
};

}  // namespace thalweg::lab
