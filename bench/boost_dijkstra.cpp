// SPDX-License-Identifier: Apache-2.0
#include "boost_dijkstra.hpp"

#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>

namespace thalweg::bench {
namespace {

struct Weight {
  Millis cost = 0;
};
using Rows = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, Weight>;

struct Met {};
class UntilMet : public boost::default_dijkstra_visitor {
 public:
  explicit UntilMet(Rows::vertex_descriptor target) : target_(target) {}
  template <class Graph>
  void examine_vertex(Rows::vertex_descriptor v, const Graph& /*graph*/) const {
    if (v == target_) throw Met();
  }

 private:
  Rows::vertex_descriptor target_;
};

}  // namespace

struct BoostDijkstra::Graph {
  Rows rows;
  std::vector<Millis> distance;
};

BoostDijkstra::BoostDijkstra(const Digraph& graph, const std::vector<Millis>& costs)
    : graph_(std::make_unique<Graph>()) {
  std::vector<std::pair<std::size_t, std::size_t>> ends;
  std::vector<Weight> weights;
  for (std::size_t v = 0; v < graph.vertex_count(); ++v) {
    for (const Arc& arc : graph.out(VertexId{v})) {
      if (costs[arc.id.value] >= infinity) continue;
      ends.emplace_back(v, arc.end.value);
      weights.push_back({costs[arc.id.value]});
    }
  }
  graph_->rows =
      Rows(boost::edges_are_sorted, ends.begin(), ends.end(), weights.begin(), graph.vertex_count());
  graph_->distance.resize(graph.vertex_count());
}

BoostDijkstra::~BoostDijkstra() = default;

Millis BoostDijkstra::cost(VertexId from, VertexId to) {
  try {
    boost::dijkstra_shortest_paths(
        graph_->rows, from.value,
        boost::weight_map(boost::get(&Weight::cost, graph_->rows))
            .distance_map(boost::make_iterator_property_map(graph_->distance.begin(),
                                                            boost::get(boost::vertex_index, graph_->rows)))
            .distance_inf(infinity)
            .visitor(UntilMet(to.value)));
  } catch (const Met&) {
    return graph_->distance[to.value];
  }
  return graph_->distance[to.value];
}

}  // namespace thalweg::bench
