// SPDX-License-Identifier: Apache-2.0
// The routing engine on nets of growing size. Every figure is the CPU time of one thread unless its name says
// otherwise; a cost that differs from that of Dijkstra's algorithm ends the benchmark that found it.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>

#include "lab/boost_dijkstra.hpp"
#include "nets.hpp"
#include "routing/cch_engine.hpp"
#include "routing/next_hops.hpp"
#ifdef THALWEG_BENCH_ROUTINGKIT
#include "routing_kit.hpp"
#endif

namespace thalweg::bench {
namespace {

using State = ::benchmark::State;
constexpr std::size_t per_destination = 10;

/// What several benchmarks need of one net, made once.
struct Prepared {
  explicit Prepared(Net made) : net(std::move(made)), topology(net.graph, nested_dissection(net.graph)) {}
  Net net;
  CchTopology topology;
};
using Maker = Net (*)();

const Prepared& prepared(Maker make) {
  static Maker last = nullptr;  // one at a time: the large ones take GBs
  static std::unique_ptr<Prepared> kept;
  if (last != make) {
    kept.reset();
    kept = std::make_unique<Prepared>(make());
    last = make;
  }
  return *kept;
}

Net luxembourg() {
  const char* const cities = std::getenv("THALWEG_CITIES");
  return read_net(std::filesystem::path(cities == nullptr ? "." : cities) /
                  "luxembourg/luxembourg.net.xml.gz");
}

double peak_mb() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_maxrss) / 1024;
}

/// The same columns for every benchmark, as its CSV wants. `vehicles`: routed in an iteration.
void report(State& state, const CchTopology& topology, std::size_t vehicles = 0) {
  state.counters["vertices"] = static_cast<double>(topology.vertex_count());
  state.counters["edges"] = static_cast<double>(topology.edge_count());
  state.counters["triangles"] = static_cast<double>(topology.triangle_count());
  state.counters["climb"] = mean_climb(topology);
  state.counters["peak_MB"] = peak_mb();
  state.counters["routes/s"] =
      ::benchmark::Counter(static_cast<double>(vehicles), ::benchmark::Counter::kIsIterationInvariantRate);
}

void topology(State& state, Maker make) {
  const Net net = make();
  for (auto _ : state) {
    const CchTopology built(net.graph, nested_dissection(net.graph));
  }
  report(state, CchTopology(net.graph, nested_dissection(net.graph)));
}

template <CchWeight W>
void customise(State& state, Maker make, std::size_t threads) {
  const Prepared& on = prepared(make);
  CchMetric<W> metric;
  const std::vector<Millis> costs = live_costs(on.net, 1);
  for (auto _ : state) metric.customise(on.topology, costs, threads);
  report(state, on.topology);
}

void sweep(State& state, Maker make) {
  const Prepared& on = prepared(make);
  CchMetric<std::uint32_t> metric;
  metric.customise(on.topology, live_costs(on.net, 1));
  std::vector<VertexId> ends;
  for (const Traveller& traveller : travellers(on.net, 16, 1)) ends.push_back(traveller.waypoints.front());
  CchSweep<std::uint32_t> sweep;
  for (auto _ : state) sweep.run(on.topology, metric, ends);
  report(state, on.topology);
}

/// A lone cost, with its way or without.
void single_query(State& state, Maker make, bool with_way) {
  const Prepared& on = prepared(make);
  CchMetric<std::uint32_t> metric;
  metric.customise(on.topology, on.net.costs);
  CchLoneSearch<std::uint32_t> search;
  const auto cost = [&](VertexId from) { return from_label(search.cost(on.topology, metric, from)); };
  const auto due = travellers(on.net, 1'000, 1);
  std::vector<VertexId> roads;
  std::size_t i = 0;
  for (auto _ : state) {
    if (i == due.size()) {  // ways are remembered until the next customisation: no way is to be asked twice
      state.PauseTiming();
      metric.customise(on.topology, on.net.costs);
      i = 0;
      state.ResumeTiming();
    }
    const Traveller& traveller = due[i++];
    const VertexId from = traveller.route.front();
    const VertexId to = traveller.waypoints.front();
    search.start(on.topology, metric, to);
    ::benchmark::DoNotOptimize(cost(from));
    roads.clear();
    if (with_way && !search.only_way(on.net.graph, on.net.costs, on.topology, metric, from, roads)) {
      walk_next_hops(on.net.graph, on.net.costs, from, to, cost, roads);
    }
  }
  report(state, on.topology);
}

Millis dijkstra_cost(const Net& net, const std::vector<Millis>& costs, VertexId from, VertexId to, Tree& tree,
                     DijkstraScratch& scratch) {
  dijkstra<Direction::backward>(net.graph, {&to, 1}, [&](ArcId arc) { return costs[arc.value]; }, tree,
                                scratch, {&from, 1});
  return tree.label[from];
}

/// Ends the program unless `cost(from, to)` of the first travellers is that of Dijkstra's algorithm.
template <class Cost>
void expect_exact(const Net& net, std::span<const Traveller> due, const Cost& cost) {
  Tree tree;
  DijkstraScratch scratch;
  for (const Traveller& traveller : due.first(20)) {
    const VertexId from = traveller.route.front();
    const VertexId to = traveller.waypoints.front();
    if (cost(from, to) == dijkstra_cost(net, net.costs, from, to, tree, scratch)) continue;
    std::cerr << "a peer's cost differs from that of Dijkstra's algorithm\n";
    std::exit(1);
  }
}

/// A round: new costs, customisation, sweeps, and the way of every vehicle. The first and every 97th is held
/// against Dijkstra's algorithm.
void round_of(State& state, Maker make, std::size_t vehicles, std::size_t per_end, std::size_t threads,
              CchMethod method) {
  const Prepared& on = prepared(make);
  const auto due = travellers(on.net, vehicles, per_end);
  CchEngine engine(threads, {});
  Legs legs;
  std::uint64_t round = 0;
  std::vector<Millis> costs = live_costs(on.net, round);
  legs.collect({due.data(), 1});
  engine.serve(on.net.graph, costs, legs, 0, legs.group_count(), method);  // builds what stays
  for (auto _ : state) {
    state.PauseTiming();
    costs = live_costs(on.net, ++round);
    legs.collect(due);
    state.ResumeTiming();
    engine.serve(on.net.graph, costs, legs, 0, legs.group_count(), method);
  }
  Tree tree;
  DijkstraScratch scratch;
  for (std::size_t g = 0; g < legs.group_count(); g += 97) {
    const Leg& leg = legs.group(g).front();
    if (dijkstra_cost(on.net, costs, leg.origin, leg.destination, tree, scratch) != leg.cost) {
      state.SkipWithError("a cost differs from that of Dijkstra's algorithm");
      std::exit(1);
    }
  }
  report(state, on.topology, vehicles);
}

void dijkstra_query(State& state, Maker make) {
  const Prepared& on = prepared(make);
  const auto due = travellers(on.net, 1'000, 1);
  Tree tree;
  DijkstraScratch scratch;
  std::size_t i = 0;
  for (auto _ : state) {
    const Traveller& traveller = due[i++ % due.size()];
    ::benchmark::DoNotOptimize(dijkstra_cost(on.net, on.net.costs, traveller.route.front(),
                                             traveller.waypoints.front(), tree, scratch));
  }
  report(state, on.topology);
}

void boost_query(State& state, Maker make) {
  const Prepared& on = prepared(make);
  std::vector<std::int32_t> costs(on.net.costs.size());  // a closed arc costs more than any way
  std::transform(on.net.costs.begin(), on.net.costs.end(), costs.begin(), [](Millis c) {
    return static_cast<std::int32_t>(std::min<Millis>(c, std::numeric_limits<std::int32_t>::max()));
  });
  lab::BoostDijkstra boost(on.net.graph, costs);
  const auto due = travellers(on.net, 1'000, 1);
  expect_exact(on.net, due, [&](VertexId from, VertexId to) { return boost.run(from, to); });
  std::size_t i = 0;
  for (auto _ : state) {
    const Traveller& traveller = due[i++ % due.size()];
    ::benchmark::DoNotOptimize(boost.run(traveller.route.front(), traveller.waypoints.front()));
  }
  report(state, on.topology);
}

#ifdef THALWEG_BENCH_ROUTINGKIT
void routing_kit_customise(State& state, Maker make) {
  const Prepared& on = prepared(make);
  RoutingKit peer(on.net.graph, on.topology.order(), live_costs(on.net, 1));
  for (auto _ : state) peer.customise();
  report(state, on.topology);
}

/// A lone cost, with its way or without.
void routing_kit_query(State& state, Maker make, bool with_way) {
  const Prepared& on = prepared(make);
  RoutingKit peer(on.net.graph, on.topology.order(), on.net.costs);
  const auto due = travellers(on.net, 1'000, 1);
  expect_exact(on.net, due, [&](VertexId from, VertexId to) { return peer.cost(from, to); });
  std::size_t i = 0;
  for (auto _ : state) {
    const Traveller& traveller = due[i++ % due.size()];
    ::benchmark::DoNotOptimize(peer.cost(traveller.route.front(), traveller.waypoints.front()));
    if (with_way) ::benchmark::DoNotOptimize(peer.unpack());
  }
  report(state, on.topology);
}
#endif

template <class Function, class... Arguments>
void add(const std::string& name, Function function, Arguments... arguments) {
  ::benchmark::RegisterBenchmark(name.c_str(), [=](State& state) { function(state, arguments...); })
      ->Unit(name.starts_with("query") ? ::benchmark::kMicrosecond : ::benchmark::kMillisecond)
      ->MeasureProcessCPUTime();
}

void add_net(const std::string& name, Maker make, bool single_queries) {
  add("topology/" + name, topology, make);
  add("customise/32 bits/" + name, customise<std::uint32_t>, make, std::size_t{1});
  add("customise/64 bits/" + name, customise<std::uint64_t>, make, std::size_t{1});
  add("customise/32 bits, 2 threads/" + name, customise<std::uint32_t>, make, std::size_t{2});
  add("sweep to 16/" + name, sweep, make);
  add("query/hierarchy/" + name, single_query, make, false);
  add("query/hierarchy, with its way/" + name, single_query, make, true);
#ifdef THALWEG_BENCH_ROUTINGKIT
  add("customise/RoutingKit/" + name, routing_kit_customise, make);
  add("query/RoutingKit/" + name, routing_kit_query, make, false);
  add("query/RoutingKit, with its way/" + name, routing_kit_query, make, true);
#endif
  if (single_queries) {
    add("query/Dijkstra/" + name, dijkstra_query, make);
    add("query/Boost/" + name, boost_query, make);
  }
  for (const std::size_t vehicles : {100U, 1'000U, 10'000U}) {
    add("round/" + std::to_string(vehicles) + "/" + name, round_of, make, vehicles, per_destination,
        std::size_t{1}, CchMethod::hierarchy);
  }
  for (const std::size_t per_end : {1U, 10U, 100U}) {
    const std::string what = std::to_string(per_end) + " a destination/" + name;
    const std::size_t vehicles = 64 * per_end;
    add("round/sweeps, " + what, round_of, make, vehicles, per_end, std::size_t{1}, CchMethod::sweeps);
    add("round/lone searches, " + what, round_of, make, vehicles, per_end, std::size_t{1},
        CchMethod::lone_searches);
    if (single_queries)
      add("round/trees, " + what, round_of, make, vehicles, per_end, std::size_t{1}, CchMethod::trees);
  }
  add("round/10000, 2 threads/" + name, round_of, make, std::size_t{10'000}, per_destination, std::size_t{2},
      CchMethod::hierarchy);
}

}  // namespace
}  // namespace thalweg::bench

int main(int argc, char** argv) {
  using namespace thalweg::bench;
  benchmark::Initialize(&argc, argv);
  if (std::getenv("THALWEG_CITIES") == nullptr) {
    std::cerr << "set THALWEG_CITIES to the folder with luxembourg/luxembourg.net.xml.gz\n";
    return 1;
  }
  add_net("luxembourg", &luxembourg, true);
  add_net(
      "luxembourg*9", [] { return glued(luxembourg(), 3, 3); }, true);
  add_net(
      "luxembourg*35", [] { return glued(luxembourg(), 7, 5); }, false);
  add_net(
      "luxembourg*182", [] { return glued(luxembourg(), 14, 13); }, false);
  add_net(
      "grid113", [] { return grid(113); }, true);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
