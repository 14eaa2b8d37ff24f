// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <memory>
#include <tuple>
#include <utility>

#include "core/parallel.hpp"
#include "routing/strategy.hpp"
#include "search/tree.hpp"

namespace thalweg {

/// Decides by the paper's service trees: one backward tree from a destination serves every vehicle of the
/// batch that goes there. A way through waypoints is a leg from each to the next, and each leg a member of
/// the tree of its end. `Search` is the algorithm that grows a tree:
///     void operator()(const Digraph&, const std::vector<Millis>& costs, VertexId destination,
///                     std::span<const VertexId> origins, Tree& out)
/// exact or not; a strategy is default-constructible search state, one a thread.
template <class Search>
class ServiceTreeStrategy : public Strategy {
 public:
  explicit ServiceTreeStrategy(const StrategyOptions& options)
      : rule_(options.rule), scratch_(std::max<std::size_t>(1, options.threads)) {}

  void decide(std::span<const ClassTraffic> traffic, std::span<const Traveller> due,
              std::vector<Decision>& decisions) override {
    collect_legs(due);
    parallel_for(first_leg_.size() - 1, scratch_.size(), [&](std::size_t tree, std::size_t worker) {
      serve(traffic, std::span(legs_).subspan(first_leg_[tree], first_leg_[tree + 1] - first_leg_[tree]),
            scratch_[worker]);
    });
    std::sort(legs_.begin(), legs_.end(), [](const Leg& a, const Leg& b) {
      return std::tie(a.traveller, a.number) < std::tie(b.traveller, b.number);
    });
    decisions.assign(due.size(), {});
    std::size_t leg = 0;
    for (std::size_t i = 0; i < due.size(); ++i) {
      const std::size_t first = leg;
      while (leg < legs_.size() && legs_[leg].traveller == i) ++leg;
      join(traffic[due[i].vehicle_class], due[i], std::span(legs_).subspan(first, leg - first), decisions[i]);
    }
  }

 private:
  struct Leg {
    std::size_t vehicle_class;
    VertexId destination;
    VertexId origin;
    std::size_t traveller;
    std::size_t number;
    Millis cost = infinity;
    std::vector<VertexId> roads{};  ///< after `origin`, up to the destination
  };
  struct Scratch {
    Search search;
    Tree tree;
    std::vector<VertexId> origins;
  };

  void collect_legs(std::span<const Traveller> due) {
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
    first_leg_.clear();
    for (std::size_t i = 0; i < legs_.size(); ++i) {
      const bool same_tree = i > 0 && legs_[i].vehicle_class == legs_[i - 1].vehicle_class &&
                             legs_[i].destination == legs_[i - 1].destination;
      if (!same_tree) first_leg_.push_back(i);
    }
    first_leg_.push_back(legs_.size());
  }

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

  void join(const ClassTraffic& seen, const Traveller& traveller, std::span<const Leg> legs,
            Decision& decision) const {
    decision.old_cost = route_cost(seen, traveller.route);
    decision.new_cost = infinity;
    if (legs.empty()) return;
    Millis cost = seen.road_times[seen.graph->road(legs.back().destination)];
    for (const Leg& leg : legs) cost = add_saturating(cost, leg.cost);
    if (cost >= infinity) return;
    decision.new_cost = cost;
    decision.route.push_back(traveller.route.front());
    for (const Leg& leg : legs) {
      decision.route.insert(decision.route.end(), leg.roads.begin(), leg.roads.end());
    }
    decision.change =
        decision.route != traveller.route && rule_.prefers(traveller, decision.old_cost, decision.new_cost);
  }

  ChoiceRule rule_;
  std::vector<Scratch> scratch_;
  std::vector<Leg> legs_;
  std::vector<std::size_t> first_leg_;  ///< of each tree, and one past the last
};

}  // namespace thalweg
