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

/// Readings of "w_i = c i", which multiplies every total by c and so cannot move a rank:
/// - table: as it is written
/// - fixed-range: the weights stay within 1 .. N, so a gap of c leaves N / c of them
/// - linear: w = c I, without a table
/// - short-rows: the table's rows end at `row`, an index beyond them weighs nothing (as an undefined entry
/// does
///   in PHP, the paper's language), and the gap is that of the indices
const std::array<std::string, 4> readings{"table", "fixed-range", "linear", "short-rows"};

DynamicGrid::Position one(const DynamicGrid& grid, std::string_view reading, std::uint64_t n,
                          std::uint64_t gap, std::size_t row, Dice& dice, DynamicGrid::Scratch& scratch) {
  const auto c = static_cast<std::int64_t>(gap);
  if (reading == "linear") return grid.rank_linear(c, dice, scratch);
  if (reading == "fixed-range")
    return grid.rank(even_array(std::max<std::uint64_t>(1, n / gap), c), dice, scratch, {});
  if (reading == "short-rows")
    return grid.rank(even_array(n, 1), dice, scratch, {.row_length = row, .index_factor = c});
  return grid.rank(even_array(n, c), dice, scratch, {});
}

Report run(const Run& run) {
  const std::uint64_t side = run.parameters.count("size");
  verify_dynamic(side, run.threads);
  const std::size_t row_length = run.parameters.count("row", 1);
  const DynamicGrid grid(side);
  Report report{.header = {"reading", "c", "N"}};
  for (const auto& name : Rankings::header()) report.header.push_back(name);
  std::vector<DynamicGrid::Scratch> scratches(run.threads);
  for (const std::string_view reading : split(run.parameters.text("reading"), ", ")) {
    verify(std::find(readings.begin(), readings.end(), reading) != readings.end(),
           fmt::format("there is no reading '{}'{}", reading, did_you_mean(reading, readings)));
    for (const std::uint64_t gap : run.parameters.list("gap", 1)) {
      for (const std::uint64_t n : run.parameters.list("weights", 1)) {
        std::vector<DynamicGrid::Position> all(run.repetitions);
        run.repeat(fmt::format("{}, c {}, N {}", reading, gap, n),
                   [&](std::size_t repetition, std::size_t worker) {
                     Dice dice(run.seed ^ n, repetition);  // the same draws for every gap
                     all[repetition] = one(grid, reading, n, gap, row_length, dice, scratches[worker]);
                   });
        std::vector<std::string> row{std::string(reading), cell(gap), cell(n)};
        Rankings(std::move(all)).add_to(row);
        report.rows.push_back(std::move(row));
      }
    }
  }
  return report;
}

}  // namespace

Experiment density_experiment() {
  return {.name = "density",
          .summary = "F-density: the same with weights c, 2c, .. Nc, under several readings",
          .parameters = {{"size", "INT", "10", "Side k of the grid"},
                         {"weights", "LIST", "20,60,100,140,180", "N: how many weights"},
                         {"gap", "LIST", "1..5", "c"},
                         {"row", "INT", "100", "Length of the table's rows in the reading short-rows"},
                         {"reading", "STR", "table,fixed-range,linear,short-rows", "Which of the readings"}},
          .repetitions = 60,
          .run = run};
}

}  // namespace thalweg::lab
