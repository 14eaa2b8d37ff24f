// SPDX-License-Identifier: Apache-2.0
#include "lab/boost_dijkstra.hpp"

#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>

namespace thalweg::lab {
namespace {

struct Met {};
class UntilMet : public boost::default_dijkstra_visitor {
 public:
  explicit UntilMet(std::uint32_t target) : target_(target) {}
  template <class Graph>
  void examine_vertex(std::uint32_t v, const Graph& /*graph*/) const {
    if (v == target_) throw Met();
  }

 private:
  std::uint32_t target_;
};

}  // namespace

struct BoostDijkstra::Graph {
  using Rows = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                                  boost::no_property, std::uint32_t, std::uint32_t>;
  Rows rows;
  std::vector<std::int32_t> costs;  ///< in the rows' order; as narrow as those of the other engines
  std::vector<Millis> labels;
  std::vector<std::uint32_t> parents;

  template <class Visitor>
  void run(VertexId source, const Visitor& visitor) {
    const auto vertex_index = boost::get(boost::vertex_index, rows);
    const auto edge_index = boost::get(boost::edge_index, rows);
    boost::dijkstra_shortest_paths(
        rows, source.value,
        boost::weight_map(boost::make_iterator_property_map(costs.cbegin(), edge_index))
            .distance_map(boost::make_iterator_property_map(labels.begin(), vertex_index))
            .predecessor_map(boost::make_iterator_property_map(parents.begin(), vertex_index))
            .visitor(visitor));
  }
};

BoostDijkstra::BoostDijkstra(const Digraph& graph, std::span<const std::int32_t> costs)
    : graph_(std::make_unique<Graph>()) {
  const auto count = graph.vertex_count();
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
  ends.reserve(graph.arc_count());
  graph_->costs.reserve(graph.arc_count());
  for (std::size_t v = 0; v < count; ++v) {
    for (const Arc& arc : graph.out(VertexId{v})) {
      ends.emplace_back(static_cast<std::uint32_t>(v), arc.end.value);
      graph_->costs.push_back(costs[arc.id.value]);
    }
  }
  graph_->rows =
      Graph::Rows(boost::edges_are_sorted, ends.begin(), ends.end(), static_cast<std::uint32_t>(count));
  graph_->labels.resize(count);
  graph_->parents.resize(count);
}

BoostDijkstra::~BoostDijkstra() = default;

void BoostDijkstra::run(VertexId source) {
  graph_->run(source, boost::dijkstra_visitor<boost::null_visitor>());
}

Millis BoostDijkstra::run(VertexId source, VertexId target) {
  try {
    graph_->run(source, UntilMet(target.value));
  } catch (const Met&) {  // Boost's own way of ending a search
  }
  return graph_->labels[target.value];
}

const std::vector<Millis>& BoostDijkstra::labels() const { return graph_->labels; }

}  // namespace thalweg::lab
