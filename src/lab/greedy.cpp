// SPDX-License-Identifier: Apache-2.0
#include "search/greedy.hpp"

#include <fmt/format.h>

#include "core/dice.hpp"
#include "core/number.hpp"
#include "graph/grid.hpp"
#include "lab/list.hpp"
#include "lab/weights.hpp"
#include "search/dijkstra.hpp"
#include "search/hybrid.hpp"

namespace thalweg::lab {
namespace {

constexpr double bytes_per_vertex = 600;

struct Outcome {
  std::size_t arcs = 0;  ///< of the greedy path
  Millis greedy = 0;
  Millis hybrid = 0;
  Millis optimal = 0;
};

struct Scratch {
  Regions regions;
  Tree tree;
  DijkstraScratch dijkstra;
  std::vector<Millis> costs;
};

double percent(std::size_t part, std::size_t whole) {
  return 100 * static_cast<double>(part) / static_cast<double>(whole);
}

std::vector<Outcome> outcomes(const Run& run, std::string_view distribution, std::uint64_t side) {
  const Digraph grid = grid_graph(side);
  const std::size_t batch = run.parameters.count("batch");
  std::vector<Outcome> out(run.repetitions);
  std::vector<Scratch> scratches(run.threads);
  run.repeat(fmt::format("{}, side {}", distribution, side), [&](std::size_t repetition, std::size_t worker) {
    auto& [regions, tree, dijkstra_scratch, costs] = scratches[worker];
    Dice dice(run.seed ^ side, repetition);
    const auto array = assignment_array(distribution, side, dice);
    costs.resize(grid.arc_count());
    for (Millis& c : costs) c = dice.pick(array);
    const auto cost = [&c = costs](ArcId arc) { return c[arc.value]; };
    const VertexId origin{0U};
    const VertexId corner{side * side - 1};
    partition<Direction::forward>(grid, {&origin, 1}, regions);
    hybrid<Direction::forward>(grid, regions, cost, tree);
    Outcome& outcome = out[repetition];
    outcome.hybrid = tree.label[corner];
    const GreedyHybrid greedy = greedy_hybrid(grid, origin, corner, cost, batch);
    outcome.arcs = greedy.path.size();
    outcome.greedy = greedy.cost;
    dijkstra<Direction::forward>(grid, {&origin, 1}, cost, tree, dijkstra_scratch);
    outcome.optimal = tree.label[corner];
  });
  return out;
}

Report run(const Run& run) {
  Report report{.header = {"distribution", "side", "length: greedy longer [%]", "length: equal [%]",
                           "weight: greedy heavier [%]", "weight: equal [%]", "weight: greedy wins [%]",
                           "greedy excess over hybrid, mean [%]", "95 % half width [%]", "hybrid optimal [%]",
                           "greedy optimal [%]"}};
  const auto sides = run.parameters.list("size");
  for (const std::uint64_t side : sides) verify_grid(side, bytes_per_vertex);
  for (const std::string_view name : split(run.parameters.text("distribution"), ", ")) {
    for (const std::uint64_t side : sides) {
      const auto all = outcomes(run, name, side);
      const std::size_t fewest = 2 * (side - 1);
      const auto share = [&](auto holds) {
        return cell(
            percent(static_cast<std::size_t>(std::count_if(all.begin(), all.end(), holds)), all.size()), 1);
      };
      std::vector<double> excess;
      excess.reserve(all.size());
      for (const Outcome& o : all)
        excess.push_back(100 * (static_cast<double>(o.greedy) / static_cast<double>(o.hybrid) - 1));
      std::vector<std::string> row{std::string(name),
                                   cell(side),
                                   share([&](const Outcome& o) { return o.arcs > fewest; }),
                                   share([&](const Outcome& o) { return o.arcs == fewest; }),
                                   share([](const Outcome& o) { return o.greedy > o.hybrid; }),
                                   share([](const Outcome& o) { return o.greedy == o.hybrid; }),
                                   share([](const Outcome& o) { return o.greedy < o.hybrid; })};
      add_estimate(row, estimate(excess), 2);
      row.push_back(share([](const Outcome& o) { return o.hybrid == o.optimal; }));
      row.push_back(share([](const Outcome& o) { return o.greedy == o.optimal; }));
      report.rows.push_back(std::move(row));
    }
  }
  return report;
}

}  // namespace

Experiment greedy_experiment() {
  return {.name = "greedy",
          .summary = "F-greedy: greedy hybrid against hybrid on grids, path length and total weight",
          .parameters = {{"size", "LIST", "5..50/5", "Sides of the grids"},
                         {"distribution", "STR", "regular,normal,dumbbell,gaps", "Assignment arrays"},
                         {"batch", "INT", "0", "Arcs of a batch; 0: all arcs of one weight"}},
          .repetitions = 1'000,
          .run = run};
}

}  // namespace thalweg::lab
