// SPDX-License-Identifier: Apache-2.0
#include "search/evolve_rounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "core/error.hpp"
#include "core/number.hpp"
#include "graph/road_graph.hpp"
#include "lab/dissection.hpp"
#include "lab/families.hpp"
#include "lab/list.hpp"
#include "network/read_network.hpp"
#include "sumo/configuration.hpp"

namespace thalweg::lab {
namespace {

/// A way to go through the vertices in a round.
struct Sweep {
  const char* name;
  RoundUpdate update;
};
constexpr std::array<Sweep, 7> sweeps{{{"former round", RoundUpdate::from_former_round},
                                       {"in place, by number", RoundUpdate::in_place},
                                       {"in place, by region", RoundUpdate::in_place},
                                       {"in place, against the regions", RoundUpdate::in_place},
                                       {"in place, by dissection rank", RoundUpdate::in_place},
                                       {"in place, against the dissection rank", RoundUpdate::in_place},
                                       {"in place, at random", RoundUpdate::in_place}}};

using Rounds = std::array<double, sweeps.size()>;

/// The rounds of every sweep from `source`; `cut` keeps the dissection rank of a graph for all its sources.
Rounds rounds_of(const Digraph& graph, const std::vector<Millis>& costs, VertexId source,
                 const std::vector<VertexId>& cut, Dice& dice) {
  const auto cost = [&costs](ArcId arc) { return costs[arc.value]; };
  Regions regions;
  Tree start;
  partition<Direction::forward>(graph, {&source, 1}, regions);
  hybrid<Direction::forward>(graph, regions, cost, start);
  std::vector<VertexId> by_region = regions.order;  // what is in no region has no label to change
  std::vector<VertexId> shuffled = by_region;
  dice.shuffle(shuffled);
  Rounds out{};
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    std::vector<VertexId> order;
    if (i == 2 || i == 3) order = by_region;
    if (i == 4 || i == 5) order = cut;
    if (i == 3 || i == 5) std::reverse(order.begin(), order.end());
    if (i == 6) order = shuffled;
    Tree tree = start;
    const RoundEvolution evolution =
        evolve_in_rounds<Direction::forward>(graph, cost, tree, {.update = sweeps[i].update, .order = order});
    out[i] = evolution.rounds();
  }
  return out;
}

void add_rows(const Run& run, std::string_view family, std::size_t vertices, const std::vector<Rounds>& all,
              Report& report) {
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    std::vector<double> rounds;
    rounds.reserve(all.size());
    for (const Rounds& r : all) rounds.push_back(r[i]);
    std::vector<std::string> row{std::string(family), cell(std::uint64_t{vertices}), sweeps[i].name};
    add_estimate(row, estimate(rounds), 2);
    row.push_back(cell(*std::max_element(rounds.begin(), rounds.end()), 0));
    row.push_back(cell(std::uint64_t{vertices - 1}));
    report.rows.push_back(std::move(row));
  }
  run.say(fmt::format("{}, {} vertices: done", family, vertices));
}

void run_family(const Run& run, std::string_view family, std::size_t vertices, Report& report) {
  std::vector<Rounds> all(run.repetitions);
  std::size_t count = 0;
  run.repeat(fmt::format("{}, {} vertices", family, vertices), [&](std::size_t repetition, std::size_t) {
    Dice dice(run.seed ^ vertices, repetition);
    const CostedGraph made = make_family(family, vertices, dice);
    if (repetition == 0) count = made.graph.vertex_count();
    all[repetition] = rounds_of(made.graph, made.costs, VertexId{0U}, dissection_order(made.graph), dice);
  });
  add_rows(run, family, count, all, report);
}

void run_network(const Run& run, const std::string& file, Report& report) {
  const Network network = read_network(file);
  const RoadGraph roads(network, VehicleClass::passenger);
  std::vector<Millis> costs;
  turn_costs(roads, free_flow_times(network, VehicleClass::passenger, 55.0, {}), costs);
  const auto cut = dissection_order(roads.turns());
  std::vector<VertexId> usable;
  for (std::size_t v = 0; v < roads.turns().vertex_count(); ++v) {
    if (!roads.turns().out(VertexId{v}).empty()) usable.emplace_back(v);
  }
  verify(!usable.empty(), fmt::format("{}: no road leads to another for passenger cars", file));
  std::vector<Rounds> all(run.repetitions);
  const std::string name = std::filesystem::path(file).filename().string();
  run.repeat(name, [&](std::size_t repetition, std::size_t) {
    Dice dice(run.seed, repetition);
    const VertexId source = dice.pick(usable);
    all[repetition] = rounds_of(roads.turns(), costs, source, cut, dice);
  });
  add_rows(run, name, roads.turns().vertex_count(), all, report);
}

Report run(const Run& run) {
  Report report{.header = {"family", "vertices", "rounds go", "rounds, mean", "95 % half width",
                           "rounds, most", "bound (V - 1)"}};
  const auto sizes = run.parameters.list("vertices", 4);
  for (const std::uint64_t size : sizes) verify_memory("a graph", 1'000.0 * static_cast<double>(size));
  for (const std::string_view family : split(run.parameters.text("family"), ", ")) {
    for (const std::uint64_t size : sizes) run_family(run, family, size, report);
  }
  for (const std::string& file : file_list(run.parameters.text("net-file"))) run_network(run, file, report);
  report.notes.emplace_back("rounds: the last one, which finds nothing to change, included");
  return report;
}

}  // namespace

Experiment evolve_rounds_experiment() {
  return {.name = "evolve-rounds",
          .summary = "how many rounds evolution takes, by graph, way of updating and order of the vertices",
          .parameters = {{"vertices", "LIST", "100,400,1600,6400", "About so many"},
                         {"family", "STR", "grid,random,chain", "Kinds of graph; '' for none"},
                         {"net-file", "FILE", "", "Road networks beside them, by comma", 'n'}},
          .repetitions = 10,
          .run = run};
}

}  // namespace thalweg::lab
