// SPDX-License-Identifier: Apache-2.0
#include "cch/lone_search.hpp"

#include <algorithm>

namespace thalweg {
namespace {

using EdgeIndex = CchTopology::EdgeIndex;

/// In place of an edge: several are as good.
constexpr EdgeIndex several = CchTopology::no_edge;

}  // namespace

template <CchWeight W>
void CchLoneSearch<W>::start(const CchTopology& topology, const CchMetric<W>& metric, VertexId destination) {
  if (labels_.size() != topology.vertex_count()) {
    labels_.assign(topology.vertex_count(), cch_infinity<W>);
    turns_.assign(topology.vertex_count(), Turn::unknown);
    falls_.resize(topology.vertex_count());
  } else {
    for (const Rank v : touched_) {
      labels_[v] = cch_infinity<W>;
      turns_[v] = Turn::unknown;
    }
  }
  touched_.clear();
  destination_ = topology.rank(destination);
  labels_[destination_] = 0;
  Rank v = destination_;
  while (true) {  // up the elimination tree, where all that is reached lies: the ways into the destination
    touched_.push_back(v);
    const W label = labels_[v];
    if (label < cch_infinity<W>) {
      const EdgeIndex last = topology.first_edge(v + 1);
      for (auto edge = topology.first_edge(v); edge < last; ++edge) {
        W& higher = labels_[topology.head(edge)];
        const W sum = label + metric.down[edge];
        if (sum > higher) continue;
        falls_[topology.head(edge)] = {.tail = v, .edge = sum == higher ? several : edge};
        higher = sum;
      }
    }
    if (topology.parent(v) == v) break;
    v = topology.parent(v);
  }
}

template <CchWeight W>
W CchLoneSearch<W>::cost(const CchTopology& topology, const CchMetric<W>& metric, VertexId from) {
  const Rank rank = topology.rank(from);
  chain_.clear();
  for (Rank v = rank; turns_[v] == Turn::unknown; v = topology.parent(v)) {
    chain_.push_back(v);
    if (topology.parent(v) == v) break;
  }
  while (!chain_.empty()) {
    const Rank v = chain_.back();
    chain_.pop_back();
    W rising = cch_infinity<W>;
    for (auto edge = topology.first_edge(v); edge < topology.first_edge(v + 1); ++edge) {
      rising = std::min<W>(rising, labels_[topology.head(edge)] + metric.up[edge]);
    }
    const W falling = labels_[v];
    const Turn not_down = rising < falling ? Turn::up : Turn::either;
    turns_[v] = falling < rising ? Turn::down : not_down;
    labels_[v] = std::min(rising, falling);
    touched_.push_back(v);
  }
  return labels_[rank];
}

/// The steps of the only way in the completion; false: there are several.
template <CchWeight W>
bool CchLoneSearch<W>::collect_steps(const CchTopology& topology, const CchMetric<W>& metric, Rank from) {
  steps_.clear();
  Rank at = from;
  while (turns_[at] == Turn::up) {
    EdgeIndex tight = several;
    for (auto edge = topology.first_edge(at); edge < topology.first_edge(at + 1); ++edge) {
      if (labels_[topology.head(edge)] + metric.up[edge] != labels_[at]) continue;
      if (tight != several) return false;
      tight = edge;
    }
    steps_.push_back({.lower = at, .edge = tight, .upward = true});
    at = topology.head(tight);
  }
  if (turns_[at] == Turn::either) return false;
  while (at != destination_) {
    const auto [lower, edge] = falls_[at];
    if (edge == several) return false;
    steps_.push_back({.lower = lower, .edge = edge, .upward = false});
    at = lower;
  }
  std::reverse(steps_.begin(), steps_.end());
  return true;
}

template <CchWeight W>
bool CchLoneSearch<W>::only_way(const Digraph& graph, const std::vector<Millis>& costs,
                                const CchTopology& topology, const CchMetric<W>& metric, VertexId from,
                                std::vector<VertexId>& roads) {
  if (!collect_steps(topology, metric, topology.rank(from))) return false;
  const std::size_t before = roads.size();
  while (!steps_.empty()) {
    const Step step = steps_.back();
    const Rank higher = topology.head(step.edge);
    const auto over = metric.over(graph, costs, topology, step);
    if (over == CchMetric<W>::several) {
      roads.resize(before);
      return false;
    }
    steps_.pop_back();
    if (over == CchMetric<W>::an_arc) {
      roads.push_back(topology.order()[step.upward ? higher : step.lower]);
      continue;
    }
    // Down to the vertex between, and up again; what comes first goes on top.
    const auto edge_to = [&](Rank end) { return topology.edge_between(over, end); };
    steps_.push_back({.lower = over, .edge = edge_to(step.upward ? higher : step.lower), .upward = true});
    steps_.push_back({.lower = over, .edge = edge_to(step.upward ? step.lower : higher), .upward = false});
  }
  return true;
}

template class CchLoneSearch<std::uint32_t>;
template class CchLoneSearch<std::uint64_t>;

}  // namespace thalweg
