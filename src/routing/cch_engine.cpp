// SPDX-License-Identifier: Apache-2.0
#include "routing/cch_engine.hpp"

#include <algorithm>
#include <utility>

#include "cch/width.hpp"
#include "core/parallel.hpp"
#include "graph/fingerprint.hpp"
#include "routing/next_hops.hpp"

namespace thalweg {
namespace {

constexpr std::size_t width = CchSweep<std::uint32_t>::width;

template <class Label>
void walk(const Digraph& graph, const std::vector<Millis>& costs, std::span<Leg> legs, const Label& label) {
  for (Leg& leg : legs) {
    leg.cost = label(leg.origin);
    if (leg.cost < infinity) walk_next_hops(graph, costs, leg.origin, leg.destination, label, leg.roads);
  }
}

/// Edges from a vertex's ancestors in the elimination tree, its own included: mean over all vertices.
double mean_climb(const CchTopology& topology) {
  std::vector<double> climb(topology.vertex_count());
  double sum = 0;
  for (std::size_t v = climb.size(); v-- > 0;) {
    const auto rank = static_cast<CchTopology::Rank>(v);
    const auto parent = topology.parent(rank);
    climb[v] = static_cast<double>(topology.heads(rank).size()) + (parent == rank ? 0 : climb[parent]);
    sum += climb[v];
  }
  return sum / std::max(1.0, static_cast<double>(climb.size()));
}

}  // namespace

CchEngine::CchEngine(std::size_t threads, OrderCache cache)
    : cache_(std::move(cache)), workers_(std::max<std::size_t>(1, threads)) {}

void CchEngine::serve(const Digraph& graph, const std::vector<Millis>& costs, Legs& legs, std::size_t first,
                      std::size_t last, std::optional<CchMethod> forced) {
  if (first == last) return;
  const std::uint64_t own = fingerprint(graph);
  if (own != graph_) {
    graph_ = own;
    spent_on_trees_ = 0;
    topology_.reset();
    is_customised_ = false;
  }
  if (forced.value_or(pick(graph, costs, last - first)) == CchMethod::trees) {
    grow_trees(graph, costs, legs, first, last);
    return;
  }
  if (!topology_) build(graph);
  if (!is_customised_ || costs_ != costs) customise(graph, costs);
  const std::size_t batches = (last - first + width - 1) / width;
  parallel_for(batches, workers_.size(), [&](std::size_t i, std::size_t number) {
    const Batch batch{.first = first + i * width, .last = std::min(last, first + (i + 1) * width)};
    Worker& worker = workers_[number];
    if (is_narrow_) {
      serve_batch(graph, narrow_, worker.sweep32, worker.lazy32, worker.ends, legs, batch);
    } else {
      serve_batch(graph, wide_, worker.sweep64, worker.lazy64, worker.ends, legs, batch);
    }
  });
}

CchMethod CchEngine::pick(const Digraph& graph, const std::vector<Millis>& costs, std::size_t groups) {
  const auto vertices = static_cast<double>(graph.vertex_count());
  const double trees = static_cast<double>(groups) * vertices * prices_.tree_vertex;
  if (!topology_) {  // trees are rented as long as the rent is below the price of the house
    spent_on_trees_ += trees;
    return spent_on_trees_ < vertices * prices_.built_vertex ? CchMethod::trees : CchMethod::hierarchy;
  }
  const auto batches = static_cast<double>((groups + width - 1) / width);
  double hierarchy = batches * prices_.swept_edge * static_cast<double>(topology_->edge_count());
  const double alone = static_cast<double>(groups) * prices_.lazy_edge * lone_edges_;
  hierarchy = std::min(hierarchy, alone);
  if (!is_customised_ || costs_ != costs) {
    hierarchy += prices_.triangle * static_cast<double>(topology_->triangle_count());
  }
  return trees < hierarchy ? CchMethod::trees : CchMethod::hierarchy;
}

void CchEngine::build(const Digraph& graph) {
  topology_ = std::make_unique<CchTopology>(graph, cached_dissection(graph, graph_, cache_));
  lone_edges_ = mean_climb(*topology_);
}

void CchEngine::customise(const Digraph& graph, const std::vector<Millis>& costs) {
  narrow_.customise(*topology_, costs, workers_.size());
  is_narrow_ = fits_32_bits(graph, costs) || fits_32_bits(graph, costs, *topology_, narrow_);
  if (!is_narrow_) wide_.customise(*topology_, costs, workers_.size());
  costs_ = costs;
  is_customised_ = true;
}

void CchEngine::grow_trees(const Digraph& graph, const std::vector<Millis>& costs, Legs& legs,
                           std::size_t first, std::size_t last) {
  parallel_for(last - first, workers_.size(), [&](std::size_t i, std::size_t number) {
    Worker& worker = workers_[number];
    const auto group = legs.group(first + i);
    worker.ends.clear();
    for (const Leg& leg : group) worker.ends.push_back(leg.origin);
    dijkstra<Direction::backward>(
        graph, {&group.front().destination, 1}, [&](ArcId arc) { return costs[arc.value]; }, worker.tree,
        worker.dijkstra, worker.ends);
    walk(graph, costs, group, [&](VertexId v) { return worker.tree.label[v]; });
  });
}

template <CchWeight W>
void CchEngine::serve_batch(const Digraph& graph, const CchMetric<W>& metric, CchSweep<W>& sweep,
                            CchLazyCosts<W>& lazy, std::vector<VertexId>& ends, Legs& legs,
                            Batch batch) const {
  const CchTopology& topology = *topology_;
  ends.clear();
  for (std::size_t g = batch.first; g < batch.last; ++g) ends.push_back(legs.group(g).front().destination);
  const double swept = prices_.swept_edge * static_cast<double>(topology.edge_count());
  if (static_cast<double>(ends.size()) * prices_.lazy_edge * lone_edges_ < swept) {
    for (std::size_t i = 0; i < ends.size(); ++i) {
      lazy.start(topology, metric, ends[i]);
      walk(graph, costs_, legs.group(batch.first + i),
           [&](VertexId v) { return from_label(lazy.cost(topology, metric, v)); });
    }
    return;
  }
  sweep.run(topology, metric, ends);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    walk(graph, costs_, legs.group(batch.first + i),
         [&](VertexId v) { return from_label(sweep.cost(topology, v, i)); });
  }
}

}  // namespace thalweg
