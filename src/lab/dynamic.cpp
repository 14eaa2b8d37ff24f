// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "lab/list.hpp"
#include "lab/rankings.hpp"

namespace thalweg::lab {
namespace {

Report run(const Run& run) {
  const std::uint64_t side = run.parameters.count("size");
  verify_dynamic(side, run.threads);
  const DynamicGrid grid(side);
  Report report{.header = {"N"}};
  for (const auto& name : Rankings::header()) report.header.push_back(name);
  std::vector<DynamicGrid::Scratch> scratches(run.threads);
  for (const std::uint64_t n : run.parameters.list("weights", 1)) {
    const auto array = even_array(n, 1);
    std::vector<DynamicGrid::Position> all(run.repetitions);
    run.repeat(fmt::format("N {}", n), [&](std::size_t repetition, std::size_t worker) {
      Dice dice(run.seed ^ n, repetition);
      all[repetition] = grid.rank(array, dice, scratches[worker], {});
    });
    std::vector<std::string> row{cell(n)};
    Rankings(std::move(all)).add_to(row);
    report.rows.push_back(std::move(row));
  }
  report.notes.emplace_back(
      "position: of hybrid's total among the different totals of all fewest-arc paths; average status: mean "
      "position / mean number of totals");
  return report;
}

}  // namespace

Experiment dynamic_experiment() {
  return {.name = "dynamic",
          .summary = "F-dynamic: hybrid's place among all fewest-arc paths where weights depend on the way",
          .parameters = {{"size", "INT", "10", "Side k of the grid; the indices are 1 .. k"},
                         {"weights", "LIST", "20..200/20", "N: the weights are 1 .. N"}},
          .repetitions = 200,
          .run = run};
}

}  // namespace thalweg::lab
