// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>

#include "core/error.hpp"
#include "core/nearest.hpp"
#include "core/number.hpp"
#include "lab/list.hpp"
#include "lab/rankings.hpp"

namespace thalweg::lab {
namespace {

/// What the weights look like: a table W[t][I], or steps that all vertices share.
const std::array<std::string, 2> readings{"table", "steps"};

Report run(const Run& run) {
  const std::uint64_t side = run.parameters.count("size");
  verify_dynamic(side, run.threads);
  const std::size_t steps = run.parameters.count("steps");
  const DynamicGrid grid(side);
  Report report{.header = {"weights", "N"}};
  for (const auto& name : Rankings::header()) report.header.push_back(name);
  std::vector<DynamicGrid::Scratch> scratches(run.threads);
  for (const std::string_view reading : split(run.parameters.text("reading"), ", ")) {
    verify(std::find(readings.begin(), readings.end(), reading) != readings.end(),
           fmt::format("there is no reading '{}'{}", reading, did_you_mean(reading, readings)));
    for (const std::uint64_t n : run.parameters.list("weights", 1)) {
      const auto array = even_array(n, 1);
      std::vector<DynamicGrid::Position> all(run.repetitions);
      run.repeat(fmt::format("{}, N {}", reading, n), [&](std::size_t repetition, std::size_t worker) {
        Dice dice(run.seed ^ n, repetition);
        auto& scratch = scratches[worker];
        all[repetition] = reading == "steps" ? grid.rank_steps(array, steps, dice, scratch)
                                             : grid.rank(array, dice, scratch, {});
      });
      std::vector<std::string> row{std::string(reading), cell(n)};
      Rankings(std::move(all)).add_to(row);
      report.rows.push_back(std::move(row));
    }
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
                         {"weights", "LIST", "20..200/20", "N: the weights are 1 .. N"},
                         {"reading", "STR", "table,steps",
                          "Weights in a table W[t][I], or alike at all vertices and changing in steps"},
                         {"steps", "INT", "10", "So many indices at which they change"}},
          .repetitions = 200,
          .run = run};
}

}  // namespace thalweg::lab
