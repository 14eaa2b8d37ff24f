// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "lab/list.hpp"
#include "lab/rankings.hpp"

namespace thalweg::lab {
namespace {

/// w: `count` numbers, each one of 1 .. `most` at random.
std::vector<std::int64_t> irregular_array(std::uint64_t count, std::uint64_t most, Dice& dice) {
  std::vector<std::int64_t> out(count);
  for (auto& weight : out) weight = static_cast<std::int64_t>(1 + dice.roll(most));
  return out;
}

struct Found {
  std::uint64_t weights = 0;  ///< the most for which every test was on top
  double next_share = 0;      ///< tests on top with one more, in %
};

/// Raises N from 1 until a test is not on top.
Found most_weights(const Run& run, const DynamicGrid& grid, std::uint64_t most, bool short_rows,
                   std::vector<DynamicGrid::Scratch>& scratches) {
  Found found;
  const std::uint64_t limit = run.parameters.count("max-weights", 1);
  while (found.weights < limit) {
    const std::uint64_t n = found.weights + 1;
    std::vector<DynamicGrid::Position> all(run.repetitions);
    run.repeat(fmt::format("|Y| {}, N {}", most, n), [&](std::size_t repetition, std::size_t worker) {
      Dice dice(run.seed ^ (most << 20U) ^ n, repetition);
      const auto array = irregular_array(n, most, dice);
      all[repetition] =
          grid.rank(array, dice, scratches[worker], {.row_length = short_rows ? std::size_t{n} : 0});
    });
    const auto top = std::count_if(all.begin(), all.end(), [](const auto& p) { return p.position == 1; });
    found.next_share = 100 * static_cast<double>(top) / static_cast<double>(all.size());
    if (!Rankings(std::move(all)).all_on_top()) break;
    found.weights = n;
  }
  return found;
}

Report run(const Run& run) {
  const std::uint64_t side = run.parameters.count("size");
  verify_dynamic(side, run.threads);
  const DynamicGrid grid(side);
  std::vector<DynamicGrid::Scratch> scratches(run.threads);
  Report report{.header = {"reading", "|Y|", "most N on top every time", "eta = |Y| / N", "log10 eta",
                           "on top with N + 1 [%]"}};
  for (const bool short_rows : {false, true}) {
    std::vector<double> etas;
    for (const std::uint64_t most : run.parameters.list("y", 1)) {
      const Found found = most_weights(run, grid, most, short_rows, scratches);
      const double eta = static_cast<double>(most) / static_cast<double>(found.weights);
      etas.push_back(eta);
      report.rows.push_back({short_rows ? "rows as long as w" : "full rows", cell(most), cell(found.weights),
                             cell(eta), cell(std::log10(eta)), cell(found.next_share, 1)});
    }
    report.notes.push_back(fmt::format("{}: mean eta {:.2f}, from {:.2f} to {:.2f}",
                                       short_rows ? "rows as long as w" : "full rows", estimate(etas).mean,
                                       *std::min_element(etas.begin(), etas.end()),
                                       *std::max_element(etas.begin(), etas.end())));
  }
  return report;
}

}  // namespace

Experiment regular_experiment() {
  return {.name = "regular",
          .summary = "F-regular: how many weights, dealt from 1 .. |Y|, still put hybrid on top every time",
          .parameters = {{"size", "INT", "10", "Side k of the grid"},
                         {"y", "LIST", "10..100/10", "|Y|: the weights come from 1 .. |Y|"},
                         {"max-weights", "INT", "200", "The search for N ends there"}},
          .repetitions = 20,
          .run = run};
}

}  // namespace thalweg::lab
