// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "core/dice.hpp"
#include "core/error.hpp"
#include "lab/list.hpp"

namespace thalweg::lab {
namespace {

/// Choices x1 < x2 < y of 1 .. n with x1 + x2 < y: for each y, the pairs below it, (y - 2)^2 / 4 rounded
/// down.
double anti_triples(std::uint64_t n) {
  double count = 0;
  for (std::uint64_t y = 3; y <= n; ++y) {
    const std::uint64_t most = y - 2;
    // x1 + x2 <= y - 1 with x1 < x2: floor(most / 2) * ceil(most / 2)
    const std::uint64_t half = most / 2;
    count += static_cast<double>(half) * static_cast<double>(most - half);
  }
  return count;
}

/// Choices of x and y with 2 x < y <= n.
double anti_equal_pairs(std::uint64_t n) {
  double count = 0;
  for (std::uint64_t x = 1; 2 * x < n; ++x) count += static_cast<double>(n - 2 * x);
  return count;
}

Report run(const Run& run) {
  Report report{.header = {"n", "x1 + x2 < y, exact", "drawn", "95 % half width",
                           "y on the given side, exact", "equal pair, exact", "equal pair x n / 3", "paper",
                           "paper, given side"}};
  for (const std::uint64_t n : run.parameters.list("n", 3)) {
    verify(n <= 2'000'000, fmt::format("--n {}: at most 2000000", n));
    const auto size = static_cast<double>(n);
    const double triples = size * (size - 1) * (size - 2) / 6;
    std::vector<double> drawn(run.repetitions);
    run.repeat(fmt::format("n {}", n), [&](std::size_t repetition, std::size_t) {
      Dice dice(run.seed ^ n, repetition);
      const std::uint64_t a = 1 + dice.roll(n);
      std::uint64_t b = a;
      while (b == a) b = 1 + dice.roll(n);
      std::uint64_t c = a;
      while (c == a || c == b) c = 1 + dice.roll(n);
      const std::uint64_t y = std::max({a, b, c});
      drawn[repetition] = a + b + c - y < y ? 1 : 0;
    });
    const double share = anti_triples(n) / triples;
    const double equal = anti_equal_pairs(n) / triples;
    std::vector<std::string> row{cell(n), cell(share, 4)};
    add_estimate(row, estimate(drawn), 4);
    for (const double value : {share / 3, equal, equal * size / 3}) row.push_back(cell(value, 4));
    row.insert(row.end(), {"0.48", "0.17"});
    report.rows.push_back(std::move(row));
  }
  report.notes.emplace_back("limits: 1/2, 1/6 and 3/(2n) (the paper prints 0.48, 0.17 and 3/n)");
  return report;
}

}  // namespace

Experiment triangle_experiment() {
  return {
      .name = "triangle",
      .summary = "P-triangle: do the smaller two of three different numbers sum to less than the greatest?",
      .parameters = {{"n", "LIST", "5,10,20,50,100,200,500,1000,10000", "Numbers 1 .. n"}},
      .repetitions = 20'000,
      .run = run};
}

}  // namespace thalweg::lab
