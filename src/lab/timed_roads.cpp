// SPDX-License-Identifier: Apache-2.0
#include "lab/timed_roads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

#include "core/error.hpp"
#include "traffic/weight_file.hpp"
#include "xml/reader.hpp"

namespace thalweg::lab {
namespace {

class IntervalHandler : public xml::Handler {
 public:
  void start(const xml::Element& element) override {
    if (element.name() != "interval") return;
    begins.push_back(element.time("begin") / 1000);
    end = std::max(end, element.time("end") / 1000);
  }
  std::vector<Seconds> begins;
  Seconds end = 0;
};

std::vector<Seconds> in_seconds(const RoadGraph& roads, const RoadTimes& times) {
  std::vector<Millis> costs;
  turn_costs(roads, times, costs);
  for (Millis& cost : costs) {
    if (cost < infinity) cost = std::max<Millis>(1, (cost + 500) / 1000);
  }
  return costs;
}

}  // namespace

TimedCosts TimedCosts::read(const std::filesystem::path& file, const Network& network,
                            const RoadGraph& roads) {
  IntervalHandler intervals;
  xml::read(file, intervals);
  verify(!intervals.begins.empty(), fmt::format("'{}' has no interval", file.string()));
  std::sort(intervals.begins.begin(), intervals.begins.end());
  const RoadTimes free_flow = free_flow_times(network, roads.vehicle_class(), 55.0, {});
  std::vector<std::vector<Seconds>> costs{in_seconds(roads, free_flow)};
  for (const Seconds begin : intervals.begins) {
    RoadTimes times = free_flow;
    apply_weight_file(file, network, begin * 1000, times);
    costs.push_back(in_seconds(roads, times));
  }
  intervals.begins.push_back(intervals.end);
  costs.push_back(costs.front());
  return {std::move(intervals.begins), std::move(costs)};
}

Seconds TimedCosts::operator()(ArcId arc, Seconds entry) const {
  const auto next = std::upper_bound(begins_.begin(), begins_.end(), entry);
  return costs_[static_cast<std::size_t>(next - begins_.begin())][arc.value];
}

void timed_hybrid(const Digraph& graph, const Regions& regions, const TimedCosts& costs, Departure from,
                  TimedTree& out) {
  out.arrival.assign(graph.vertex_count(), never);
  out.parent.assign(graph.vertex_count(), ArcId{});
  out.arrival[from.source] = from.time;
  for (std::size_t i = regions.first[1]; i < regions.order.size(); ++i) {
    const VertexId u = regions.order[i];
    for (const Arc& arc : graph.in(u)) {
      if (regions.number[arc.end] + 1 != regions.number[u] || out.arrival[arc.end] >= never) continue;
      const Seconds entry = out.arrival[arc.end];
      const Seconds arrival = add_saturating(entry, costs(arc.id, entry));
      if (arrival >= out.arrival[u]) continue;
      out.arrival[u] = arrival;
      out.parent[u] = arc.id;
    }
  }
}

TimedEvolution timed_evolution(const Digraph& graph, const TimedCosts& costs, TimedTree& tree) {
  TimedEvolution out;
  while (out.rounds < graph.vertex_count() && !out.settled) {
    out.settled = true;
    for (std::size_t v = 0; v < graph.vertex_count(); ++v) {
      const VertexId u{v};
      for (const Arc& arc : graph.in(u)) {
        const Seconds entry = tree.arrival[arc.end];
        if (entry >= never) continue;
        const Seconds arrival = add_saturating(entry, costs(arc.id, entry));
        if (arrival >= tree.arrival[u]) continue;
        tree.arrival[u] = arrival;
        tree.parent[u] = arc.id;
        out.settled = false;
      }
    }
    ++out.rounds;
  }
  return out;
}

void timed_dijkstra(const Digraph& graph, const TimedCosts& costs, Departure from, TimedTree& out) {
  out.arrival.assign(graph.vertex_count(), never);
  out.parent.assign(graph.vertex_count(), ArcId{});
  using Entry = std::pair<Seconds, VertexId>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  out.arrival[from.source] = from.time;
  queue.emplace(from.time, from.source);
  while (!queue.empty()) {
    const auto [entry, u] = queue.top();
    queue.pop();
    if (entry > out.arrival[u]) continue;
    for (const Arc& arc : graph.out(u)) {
      const Seconds arrival = add_saturating(entry, costs(arc.id, entry));
      if (arrival >= out.arrival[arc.end]) continue;
      out.arrival[arc.end] = arrival;
      out.parent[arc.end] = arc.id;
      queue.emplace(arrival, arc.end);
    }
  }
}

void earliest_arrivals(const Digraph& graph, const TimedCosts& costs, Departure from, std::size_t wanted,
                       Seconds horizon, IdVector<VertexId, Seconds>& out) {
  out.assign(graph.vertex_count(), never);
  IdVector<VertexId, Seconds> seen(graph.vertex_count(), -1);  // the last second a vertex was taken in
  std::vector<std::vector<VertexId>> due(static_cast<std::size_t>(horizon) + 1);
  due[0].push_back(from.source);
  std::size_t reached = 0;
  for (Seconds second = 0; second <= horizon && reached < wanted; ++second) {
    auto& vertices = due[static_cast<std::size_t>(second)];
    for (const VertexId u : vertices) {  // costs are at least 1: nothing is added to this second
      if (std::exchange(seen[u], second) == second) continue;
      if (out[u] >= never) {
        out[u] = from.time + second;
        ++reached;
      }
      for (const Arc& arc : graph.out(u)) {
        const Seconds later = add_saturating(second, costs(arc.id, from.time + second));
        if (later <= horizon) due[static_cast<std::size_t>(later)].push_back(arc.end);
      }
    }
    vertices = {};
  }
}

Seconds replay(const Digraph& graph, const TimedCosts& costs, const TimedTree& tree, Departure from,
               VertexId target) {
  std::vector<ArcId> path;
  for (VertexId v = target; v != from.source; v = graph.ends(path.back()).tail) {
    if (!tree.parent[v].valid() || path.size() == graph.vertex_count()) return never;
    path.push_back(tree.parent[v]);
  }
  Seconds time = from.time;
  for (std::size_t i = path.size(); i-- > 0;) time = add_saturating(time, costs(path[i], time));
  return time;
}

}  // namespace thalweg::lab
