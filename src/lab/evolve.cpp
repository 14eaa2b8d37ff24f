// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "core/dice.hpp"
#include "graph/grid.hpp"
#include "lab/list.hpp"
#include "lab/weights.hpp"
#include "search/evolve_rounds.hpp"

namespace thalweg::lab {
namespace {

constexpr double bytes_per_vertex = 400;

struct Outcome {
  double improvement = 0;      ///< at the corner, in %
  double all_improvement = 0;  ///< mean over all vertices, in %
  double rounds = 0;
  double changed = 0;  ///< labels changed, per vertex
};

Report run(const Run& run) {
  Report report{.header = {"side", "vertices", "improved [%]", "improvement, mean [%]", "95 % half width [%]",
                           "improvement, greatest [%]", "improvement, all targets [%]",
                           "95 % half width, all [%]", "rounds, mean", "95 % half width", "rounds, most",
                           "rounds / vertices", "labels changed a vertex"}};
  const auto sides = run.parameters.list("size");
  for (const std::uint64_t side : sides) verify_grid(side, bytes_per_vertex);
  for (const std::uint64_t side : sides) {
    const Digraph grid = grid_graph(side);
    std::vector<Outcome> all(run.repetitions);
    run.repeat(fmt::format("side {}", side), [&](std::size_t repetition, std::size_t) {
      Dice dice(run.seed ^ side, repetition);
      const auto array = assignment_array(run.parameters.text("distribution"), side, dice);
      std::vector<Millis> costs(grid.arc_count());
      for (Millis& c : costs) c = dice.pick(array);
      const auto cost = [&costs](ArcId arc) { return costs[arc.value]; };
      const VertexId origin{0U};
      Regions regions;
      Tree hybrid_tree;
      partition<Direction::forward>(grid, {&origin, 1}, regions);
      hybrid<Direction::forward>(grid, regions, cost, hybrid_tree);
      Tree tree = hybrid_tree;
      const RoundEvolution evolution = evolve_in_rounds<Direction::forward>(grid, cost, tree);
      const auto saved = [&](std::size_t v) {
        const auto before = static_cast<double>(hybrid_tree.label[VertexId{v}]);
        return 100 * (before - static_cast<double>(tree.label[VertexId{v}])) / before;
      };
      const std::size_t count = grid.vertex_count();
      Outcome& out = all[repetition];
      out.improvement = saved(count - 1);
      for (std::size_t v = 1; v < count; ++v)
        out.all_improvement += saved(v) / static_cast<double>(count - 1);
      out.rounds = evolution.rounds();
      out.changed = static_cast<double>(evolution.total()) / static_cast<double>(count);
    });
    std::vector<double> improvement, everywhere, rounds, changed;
    std::size_t improved = 0;
    for (const Outcome& o : all) {
      improvement.push_back(o.improvement);
      everywhere.push_back(o.all_improvement);
      rounds.push_back(o.rounds);
      changed.push_back(o.changed);
      improved += o.improvement > 0 ? 1U : 0U;
    }
    const auto vertices = static_cast<double>(grid.vertex_count());
    std::vector<std::string> row{
        cell(side), cell(grid.vertex_count()),
        cell(100 * static_cast<double>(improved) / static_cast<double>(all.size()), 1)};
    add_estimate(row, estimate(improvement), 2);
    row.push_back(cell(*std::max_element(improvement.begin(), improvement.end()), 2));
    add_estimate(row, estimate(everywhere), 2);
    add_estimate(row, estimate(rounds), 2);
    row.push_back(cell(*std::max_element(rounds.begin(), rounds.end()), 0));
    row.push_back(cell(estimate(rounds).mean / vertices, 4));
    row.push_back(cell(estimate(changed).mean, 3));
    report.rows.push_back(std::move(row));
  }
  report.notes.emplace_back(
      "improvement: of evolution over hybrid, corner to corner, and from a corner to all");
  return report;
}

}  // namespace

Experiment evolve_experiment() {
  return {
      .name = "evolve",
      .summary = "C-evolve: what evolution saves over hybrid on grids, and in how many rounds",
      .parameters = {{"size", "LIST", "5..50/5,100", "Sides k of the grids"},
                     {"distribution", "STR", "regular", "Weights: regular (1 .. k), normal, dumbbell, gaps"}},
      .repetitions = 200,
      .run = run};
}

}  // namespace thalweg::lab
