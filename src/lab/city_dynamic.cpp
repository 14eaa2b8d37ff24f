// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/dice.hpp"
#include "core/error.hpp"
#include "lab/list.hpp"
#include "lab/timed_roads.hpp"
#include "network/read_network.hpp"

namespace thalweg::lab {
namespace {

/// One search against the exact arrivals, over the targets of one departure.
struct Tally {
  double pairs = 0;
  double exact = 0;         ///< arrivals, as driven, that are the earliest
  double excess = 0;        ///< sum of the delays over the earliest travel time, in %
  double inconsistent = 0;  ///< labels that their own path does not have
  double cyclic = 0;        ///< of them, those whose parents form a cycle
};

struct FromDeparture {
  Tally hybrid, evolution, dijkstra;
  TimedEvolution rounds;
  double beyond = 0;  ///< targets that no walk reaches within the horizon
};

Tally tally(const Digraph& graph, const TimedCosts& costs, const TimedTree& tree, Departure from,
            const IdVector<VertexId, Seconds>& earliest) {
  Tally out;
  for (std::size_t i = 0; i < graph.vertex_count(); ++i) {
    const VertexId v{i};
    if (v == from.source || earliest[v] >= never || tree.arrival[v] >= never) continue;
    const Seconds driven = replay(graph, costs, tree, from, v);
    ++out.pairs;
    out.inconsistent += driven != tree.arrival[v] ? 1 : 0;
    if (driven >= never) {
      ++out.cyclic;
      continue;
    }
    out.exact += driven == earliest[v] ? 1 : 0;
    out.excess +=
        100.0 * static_cast<double>(driven - earliest[v]) / static_cast<double>(earliest[v] - from.time);
  }
  return out;
}

struct Overtaking {
  double share = 0;  ///< of the arcs that have a moment at which leaving a second later arrives earlier, %
  Seconds greatest = 0;  ///< by how much
};

Overtaking overtaking(const Digraph& graph, const TimedCosts& costs) {
  Overtaking out;
  std::size_t arcs = 0;
  for (std::size_t a = 0; a < graph.arc_count(); ++a) {
    Seconds gain = 0;
    for (const Seconds begin : costs.begins()) {
      const Seconds before = costs(ArcId{a}, begin - 1);
      const Seconds after = costs(ArcId{a}, begin);
      if (before < never && after < never) gain = std::max(gain, before - 1 - after);
    }
    arcs += gain > 0 ? 1U : 0U;
    out.greatest = std::max(out.greatest, gain);
  }
  out.share = 100 * static_cast<double>(arcs) / static_cast<double>(graph.arc_count());
  return out;
}

Report run(const Run& run) {
  const auto& files = run.parameters;
  verify(!files.text("net-file").empty(), "no network: name it with --net-file");
  verify(!files.text("edgedata-file").empty(),
         "no recording: name an edgeData output of SUMO with --edgedata-file");
  const Network network = read_network(files.text("net-file"));
  const auto vehicle_class = parse_vehicle_class(files.text("vclass"));
  verify(vehicle_class.has_value(),
         fmt::format("--vclass {}: nobody knows this vehicle class", files.text("vclass")));
  const RoadGraph roads(network, *vehicle_class);
  const Digraph& turns = roads.turns();
  const TimedCosts costs = TimedCosts::read(files.text("edgedata-file"), network, roads);
  const Seconds horizon = static_cast<Seconds>(run.parameters.count("horizon", 1));
  verify_memory("the exact search", 24.0 * static_cast<double>(horizon) * static_cast<double>(run.threads));
  std::vector<VertexId> usable;
  for (std::size_t v = 0; v < turns.vertex_count(); ++v) {
    if (!turns.out(VertexId{v}).empty()) usable.emplace_back(v);
  }
  verify(!usable.empty(), "no road leads to another for this class");
  const Seconds first = costs.begins().front();
  const auto length = static_cast<std::uint64_t>(std::max<Seconds>(1, costs.begins().back() - first));

  std::vector<FromDeparture> all(run.repetitions);
  run.repeat("departures", [&](std::size_t repetition, std::size_t) {
    Dice dice(run.seed, repetition);
    const Departure from{.source = dice.pick(usable),
                         .time = first + static_cast<Seconds>(dice.roll(length))};
    FromDeparture& out = all[repetition];
    Regions regions;
    partition<Direction::forward>(turns, {&from.source, 1}, regions);
    IdVector<VertexId, Seconds> earliest;
    TimedTree dijkstra_tree;
    timed_dijkstra(turns, costs, from, dijkstra_tree);
    const auto reachable = static_cast<std::size_t>(std::count_if(
        dijkstra_tree.arrival.begin(), dijkstra_tree.arrival.end(), [](Seconds s) { return s < never; }));
    earliest_arrivals(turns, costs, from, reachable, horizon, earliest);
    const auto reached = std::count_if(earliest.begin(), earliest.end(), [](Seconds s) { return s < never; });
    out.beyond = static_cast<double>(reachable) - static_cast<double>(reached);
    out.dijkstra = tally(turns, costs, dijkstra_tree, from, earliest);
    TimedTree tree;
    timed_hybrid(turns, regions, costs, from, tree);
    out.hybrid = tally(turns, costs, tree, from, earliest);
    out.rounds = timed_evolution(turns, costs, tree);
    out.evolution = tally(turns, costs, tree, from, earliest);
  });

  Report report{.header = {"search", "departures", "pairs", "arrives earliest [%]", "95 % half width [%]",
                           "delay, mean [%]", "95 % half width, delay [%]", "labels not of their path [%]",
                           "parents in a cycle [%]", "settled [%]", "rounds, mean"}};
  const auto add_row = [&](const char* name, auto member, bool rounds) {
    std::vector<double> exact, excess, round_counts;
    Tally sum;
    double settled = 0;
    for (const FromDeparture& from : all) {
      const Tally& t = from.*member;
      if (t.pairs == 0) continue;
      exact.push_back(100 * t.exact / t.pairs);
      excess.push_back(t.excess / t.pairs);
      sum.pairs += t.pairs;
      sum.inconsistent += t.inconsistent;
      sum.cyclic += t.cyclic;
      settled += from.rounds.settled ? 1 : 0;
      round_counts.push_back(from.rounds.rounds);
    }
    std::vector<std::string> row{name, cell(std::uint64_t{exact.size()}), cell(sum.pairs, 0)};
    add_estimate(row, estimate(exact), 2);
    add_estimate(row, estimate(excess), 3);
    row.push_back(cell(100 * sum.inconsistent / sum.pairs, 3));
    row.push_back(cell(100 * sum.cyclic / sum.pairs, 3));
    row.push_back(rounds ? cell(100 * settled / static_cast<double>(exact.size()), 1) : "");
    row.push_back(rounds ? cell(estimate(round_counts).mean, 1) : "");
    report.rows.push_back(std::move(row));
  };
  add_row("hybrid, one label", &FromDeparture::hybrid, false);
  add_row("evolution, one label", &FromDeparture::evolution, true);
  add_row("Dijkstra, one label", &FromDeparture::dijkstra, false);
  const Overtaking gain = overtaking(turns, costs);
  report.notes.push_back(
      fmt::format("leaving a second later arrives earlier on {:.1f} % of the turns at some change of "
                  "interval, by up to {} s",
                  gain.share, gain.greatest));
  double beyond = 0;
  for (const FromDeparture& from : all) beyond += from.beyond;
  report.notes.push_back(fmt::format("{:.0f} pairs are beyond the horizon of {} s", beyond, horizon));
  return report;
}

}  // namespace

Experiment city_dynamic_experiment() {
  return {.name = "city-dynamic",
          .summary = "one label a vertex against the earliest arrival, in recorded traffic",
          .parameters = {{"net-file", "FILE", "", "The network", 'n'},
                         {"edgedata-file", "FILE", "", "SUMO's edgeData output with intervals (freq)"},
                         {"vclass", "STR", "passenger", "Vehicle class"},
                         {"horizon", "INT", "7200", "Seconds after departure that the exact search goes to"}},
          .repetitions = 50,
          .run = run};
}

}  // namespace thalweg::lab
