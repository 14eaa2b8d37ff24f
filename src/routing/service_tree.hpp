// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "core/parallel.hpp"
#include "routing/legs.hpp"
#include "search/tree.hpp"

namespace thalweg {

/// Decides by the paper's service trees: one backward tree from a destination serves every vehicle of the
/// batch that goes there. A way through waypoints is a leg from each to the next, and each leg a member of
/// the tree of its end. `Search` is the algorithm that grows a tree:
///     void operator()(const Digraph&, const std::vector<Millis>& costs, VertexId destination,
///                     std::span<const VertexId> origins, Tree& out)
/// exact or not; it is default-constructible search state, one a thread.
template <class Search>
class ServiceTreeStrategy : public Strategy {
 public:
  explicit ServiceTreeStrategy(const StrategyOptions& options)
      : rule_(options.rule), scratch_(std::max<std::size_t>(1, options.threads)) {}

  void decide(std::span<const ClassTraffic> traffic, std::span<const Traveller> due,
              std::vector<Decision>& decisions) override {
    legs_.collect(due);
    parallel_for(legs_.group_count(), scratch_.size(), [&](std::size_t group, std::size_t worker) {
      serve(traffic, legs_.group(group), scratch_[worker]);
    });
    legs_.decide(traffic, due, rule_, decisions);
  }

 private:
  struct Scratch {
    Search search;
    Tree tree;
    std::vector<VertexId> origins;
  };

  static void serve(std::span<const ClassTraffic> traffic, std::span<Leg> legs, Scratch& scratch) {
    const ClassTraffic& seen = traffic[legs.front().vehicle_class];
    const Digraph& turns = seen.graph->turns();
    scratch.origins.clear();
    for (const Leg& leg : legs) scratch.origins.push_back(leg.origin);
    scratch.search(turns, seen.turn_costs, legs.front().destination, scratch.origins, scratch.tree);
    for (Leg& leg : legs) {
      const auto arcs = path<Direction::backward>(turns, scratch.tree, leg.origin);
      if (!arcs) continue;
      leg.cost = scratch.tree.label[leg.origin];
      leg.roads.reserve(arcs->size());
      for (const ArcId arc : *arcs) leg.roads.push_back(turns.ends(arc).head);
    }
  }

  ChoiceRule rule_;
  std::vector<Scratch> scratch_;
  Legs legs_;
};

}  // namespace thalweg
