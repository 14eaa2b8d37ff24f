// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "cch/lone_search.hpp"
#include "cch/metric.hpp"
#include "cch/sweep.hpp"
#include "cch/width.hpp"
#include "routing/next_hops.hpp"
#include "search/dijkstra.hpp"
#include "support/random_graph.hpp"

namespace thalweg::testing {

/// Holds every way to ask a hierarchy against Dijkstra's algorithm: sweep and lone search agree with it on
/// the cost to every one of `destinations` from every vertex, the walk from each of `origins` follows arcs
/// that cost as much, and the lone search finds the same way where it is the only one, and there only.
/// Scratch is kept from one instance to the next, as the program does.
template <CchWeight W>
class CchOracle {
 public:
  void check(const CchTopology& topology, const Instance& instance, const std::vector<VertexId>& destinations,
             const std::vector<VertexId>& origins, std::size_t threads = 1) {
    metric_.customise(topology, instance.costs, threads);
    for (std::size_t first = 0; first < destinations.size(); first += CchSweep<W>::width) {
      const std::size_t count = std::min(CchSweep<W>::width, destinations.size() - first);
      sweep_.run(topology, metric_, std::span(destinations).subspan(first, count));
      for (std::size_t i = 0; i < count; ++i)
        check_one(topology, instance, destinations[first + i], i, origins);
    }
  }

  std::size_t reached = 0;   ///< pairs that are joined
  std::size_t only = 0;      ///< of these by one shortest way
  std::size_t not_only = 0;  ///< by several

 private:
  void check_one(const CchTopology& topology, const Instance& instance, VertexId destination,
                 std::size_t lane, const std::vector<VertexId>& origins) {
    const Digraph& graph = instance.graph;
    dijkstra<Direction::backward>(graph, {&destination, 1}, instance, tree_, scratch_);
    lone_.start(topology, metric_, destination);
    std::size_t different = 0;
    for (std::size_t v = 0; v < graph.vertex_count(); ++v) {
      const Millis least = tree_.label[VertexId{v}];
      const Millis swept = from_label(sweep_.cost(topology, VertexId{v}, lane));
      const Millis alone = from_label(lone_.cost(topology, metric_, VertexId{v}));
      different += swept != least || alone != least ? 1U : 0U;
    }
    ASSERT_EQ(different, 0U) << "of " << graph.vertex_count() << " costs to vertex " << destination.value;
    for (const VertexId origin : origins) {
      if (tree_.label[origin] >= infinity) continue;
      ++reached;
      roads_.assign(1, origin);
      walk_next_hops(
          graph, instance.costs, origin, destination,
          [&](VertexId v) { return from_label(sweep_.cost(topology, v, lane)); }, roads_);
      ASSERT_EQ(roads_.back(), destination);
      ASSERT_EQ(cost_of(instance, roads_), tree_.label[origin])
          << origin.value << " to " << destination.value;
      check_only_way(topology, instance, origin);
    }
  }

  /// After the walk from `origin`, which `roads_` holds.
  void check_only_way(const CchTopology& topology, const Instance& instance, VertexId origin) {
    only_.assign(1, origin);
    if (lone_.only_way(instance.graph, instance.costs, topology, metric_, origin, only_)) {
      ++only;
      ASSERT_EQ(only_, roads_);
    } else {
      ++not_only;
      ASSERT_EQ(only_, std::vector<VertexId>{origin});
    }
    const bool is_only = only_ == roads_ && roads_.size() > 1;
    const bool has_free_arcs =
        std::any_of(instance.costs.begin(), instance.costs.end(), [](Millis cost) { return cost == 0; });
    if (!has_free_arcs && roads_.size() > 1) {
      ASSERT_EQ(is_only, std::all_of(roads_.begin(), roads_.end() - 1,
                                     [&](VertexId v) { return is_clear(instance, v); }));
    }
  }

  /// Whether the shortest ways from `v` agree on where to go next.
  bool is_clear(const Instance& instance, VertexId v) const {
    VertexId next;
    for (const Arc& arc : instance.graph.out(v)) {
      if (add_saturating(instance(arc.id), tree_.label[arc.end]) != tree_.label[v]) continue;
      if (next.valid() && next != arc.end) return false;
      next = arc.end;
    }
    return true;
  }

  /// Infinity where two vertices are not joined.
  static Millis cost_of(const Instance& instance, const std::vector<VertexId>& way) {
    Millis sum = 0;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
      Millis least = infinity;
      for (const Arc& arc : instance.graph.out(way[i])) {
        if (arc.end == way[i + 1]) least = std::min(least, instance(arc.id));
      }
      sum = add_saturating(sum, least);
    }
    return sum;
  }

  CchMetric<W> metric_;
  CchSweep<W> sweep_;
  CchLoneSearch<W> lone_;
  Tree tree_;
  DijkstraScratch scratch_;
  std::vector<VertexId> roads_;
  std::vector<VertexId> only_;
};

inline std::vector<VertexId> some_vertices(const Digraph& graph, std::size_t count, Dice& dice) {
  std::vector<VertexId> some;
  for (std::size_t i = 0; i < count; ++i) some.emplace_back(dice.roll(graph.vertex_count()));
  return some;
}

}  // namespace thalweg::testing
