// SPDX-License-Identifier: Apache-2.0
#include "routing/cch_engine.hpp"

#include <algorithm>
#include <cmath>
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
  const CchMethod method = forced ? *forced : pick(graph, costs, legs, first, last);
  if (method == CchMethod::trees) {
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
      serve_batch(method, graph, narrow_, worker.sweep32, worker.lone32, worker.ends, legs, batch);
    } else {
      serve_batch(method, graph, wide_, worker.sweep64, worker.lone64, worker.ends, legs, batch);
    }
  });
}

double CchEngine::sweep_price() const {
  return prices_.swept_edge * static_cast<double>(topology_->edge_count());
}

double CchEngine::lone_price(Legs& legs, Batch batch) const {
  double sum = 0;
  for (std::size_t g = batch.first; g < batch.last; ++g)
    sum += std::sqrt(static_cast<double>(legs.group(g).size()));
  return sum * prices_.climbed_edge * climb_;
}

CchMethod CchEngine::pick(const Digraph& graph, const std::vector<Millis>& costs, Legs& legs,
                          std::size_t first, std::size_t last) {
  const auto vertices = static_cast<double>(graph.vertex_count());
  double trees = 0;
  for (std::size_t g = first; g < last; ++g) {
    const auto size = static_cast<double>(legs.group(g).size());
    trees += prices_.tree_vertex * vertices * size / (size + 1);
  }
  if (!topology_) {  // trees are rented as long as the rent is below the price of the house
    spent_on_trees_ += trees;
    return spent_on_trees_ < vertices * prices_.built_vertex ? CchMethod::trees : CchMethod::hierarchy;
  }
  double hierarchy = 0;
  for (std::size_t g = first; g < last; g += width) {
    hierarchy += std::min(sweep_price(), lone_price(legs, {.first = g, .last = std::min(last, g + width)}));
  }
  if (!is_customised_ || costs_ != costs) {
    hierarchy += prices_.triangle * static_cast<double>(topology_->triangle_count()) +
                 prices_.customised_edge * static_cast<double>(topology_->edge_count());
  }
  return trees < hierarchy ? CchMethod::trees : CchMethod::hierarchy;
}

void CchEngine::build(const Digraph& graph) {
  topology_ = std::make_unique<CchTopology>(graph, cached_dissection(graph, graph_, cache_));
  climb_ = mean_climb(*topology_);
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
void CchEngine::serve_batch(CchMethod method, const Digraph& graph, const CchMetric<W>& metric,
                            CchSweep<W>& sweep, CchLoneSearch<W>& lone, std::vector<VertexId>& ends,
                            Legs& legs, Batch batch) const {
  const CchTopology& topology = *topology_;
  ends.clear();
  for (std::size_t g = batch.first; g < batch.last; ++g) ends.push_back(legs.group(g).front().destination);
  if (method == CchMethod::lone_searches ||
      (method == CchMethod::hierarchy && lone_price(legs, batch) < sweep_price())) {
    for (std::size_t i = 0; i < ends.size(); ++i) {
      lone.start(topology, metric, ends[i]);
      const auto label = [&](VertexId v) { return from_label(lone.cost(topology, metric, v)); };
      const auto group = legs.group(batch.first + i);
      Leg& leg = group.front();
      if (group.size() == 1 && label(leg.origin) < infinity &&
          lone.only_way(graph, costs_, topology, metric, leg.origin, leg.roads)) {
        leg.cost = label(leg.origin);
      } else {  // several share the costs found on their ways
        walk(graph, costs_, group, label);
      }
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
