// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "cch/order.hpp"
#include "core/time.hpp"
#include "graph/digraph.hpp"

namespace thalweg::bench {

/// RoutingKit's customizable contraction hierarchy, by the same order as ours. Built with ROUTINGKIT_ROOT
/// only.
class RoutingKit {
 public:
  /// `costs` by ArcId; those too large for RoutingKit's 32 bits count as closed.
  RoutingKit(const Digraph& graph, const EliminationOrder& order, const std::vector<Millis>& costs);
  RoutingKit(const RoutingKit&) = delete;
  RoutingKit& operator=(const RoutingKit&) = delete;
  ~RoutingKit();

  void customise();
  /// Infinity: there is no way.
  Millis cost(VertexId from, VertexId to);
  /// The number of arcs of the way whose cost was asked last.
  std::size_t unpack();

 private:
  struct Hierarchy;
  std::unique_ptr<Hierarchy> hierarchy_;
};

}  // namespace thalweg::bench
