// SPDX-License-Identifier: Apache-2.0
#include "routing_kit.hpp"

#include <routingkit/customizable_contraction_hierarchy.h>

#include <algorithm>

namespace thalweg::bench {
namespace {

std::vector<unsigned> numbers(const EliminationOrder& order) {
  std::vector<unsigned> out(order.size());
  std::transform(order.begin(), order.end(), out.begin(), [](VertexId v) { return v.value; });
  return out;
}

std::vector<unsigned> ends(const Digraph& graph, VertexId ArcEnds::*end) {
  std::vector<unsigned> out;
  out.reserve(graph.arc_count());
  for (std::size_t arc = 0; arc < graph.arc_count(); ++arc)
    out.push_back((graph.ends(ArcId{arc}).*end).value);
  return out;
}

std::vector<unsigned> narrowed(const std::vector<Millis>& costs) {
  std::vector<unsigned> out;
  out.reserve(costs.size());
  for (const Millis cost : costs)
    out.push_back(static_cast<unsigned>(std::min<Millis>(cost, ::RoutingKit::inf_weight)));
  return out;
}

}  // namespace

struct RoutingKit::Hierarchy {
  Hierarchy(const Digraph& graph, const EliminationOrder& order, const std::vector<Millis>& live)
      : costs(narrowed(live)),
        topology(numbers(order), ends(graph, &ArcEnds::tail), ends(graph, &ArcEnds::head)),
        metric(topology, costs),
        query(metric) {
    metric.customize();
  }
  std::vector<unsigned> costs;
  ::RoutingKit::CustomizableContractionHierarchy topology;
  ::RoutingKit::CustomizableContractionHierarchyMetric metric;
  ::RoutingKit::CustomizableContractionHierarchyQuery query;
};

RoutingKit::RoutingKit(const Digraph& graph, const EliminationOrder& order, const std::vector<Millis>& costs)
    : hierarchy_(std::make_unique<Hierarchy>(graph, order, costs)) {}
RoutingKit::~RoutingKit() = default;

void RoutingKit::customise() { hierarchy_->metric.customize(); }

Millis RoutingKit::cost(VertexId from, VertexId to) {
  auto& query = hierarchy_->query;
  query.reset().add_source(from.value).add_target(to.value).run();
  const unsigned found = query.get_distance();
  return found >= ::RoutingKit::inf_weight ? infinity : static_cast<Millis>(found);
}

std::size_t RoutingKit::unpack() { return hierarchy_->query.get_arc_path().size(); }

}  // namespace thalweg::bench
