// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <numeric>

#include "core/dice.hpp"
#include "core/error.hpp"
#include "lab/list.hpp"

namespace thalweg::lab {
namespace {

/// Anti events by the length of the shorter side, one row a repetition (0 or 1 each).
struct Trials {
  std::vector<std::vector<std::uint8_t>> anti;

  [[nodiscard]] double share(std::size_t length) const {
    std::size_t count = 0;
    for (const auto& trial : anti) count += trial[length];
    return static_cast<double>(count) / static_cast<double>(anti.size());
  }
};

/// E of the numbers 1 .. A, dealt to `length` sides and to the other E - length.
Trials deal(const Run& run, std::size_t numbers, std::size_t sides, bool with_replacement) {
  const std::size_t longest = (sides - 1) / 2;
  Trials trials{.anti = std::vector(run.repetitions, std::vector<std::uint8_t>(longest + 1))};
  run.repeat(with_replacement ? "with replacement" : "without replacement",
             [&](std::size_t repetition, std::size_t) {
               Dice dice(run.seed, 2 * repetition + (with_replacement ? 1 : 0));
               std::vector<std::uint64_t> deck(numbers);
               for (std::size_t length = 1; length <= longest; ++length) {
                 std::uint64_t shorter = 0;
                 std::uint64_t longer = 0;
                 if (!with_replacement) {
                   std::iota(deck.begin(), deck.end(), std::uint64_t{1});
                   dice.shuffle(deck);
                 }
                 for (std::size_t i = 0; i < sides; ++i) {
                   const std::uint64_t weight = with_replacement ? 1 + dice.roll(numbers) : deck[i];
                   (i < length ? shorter : longer) += weight;
                 }
                 trials.anti[repetition][length] = shorter > longer ? 1 : 0;
               }
             });
  return trials;
}

Report run(const Run& run) {
  const std::size_t numbers = run.parameters.count("numbers", 3);
  const std::size_t sides = run.parameters.count("sides", 3);
  verify(sides <= numbers, fmt::format("--sides {}: there are only {} numbers to deal", sides, numbers));
  verify_memory("the table of trials", static_cast<double>(run.repetitions) * static_cast<double>(sides));
  const Trials dealt = deal(run, numbers, sides, false);
  const Trials drawn = deal(run, numbers, sides, true);
  const std::size_t longest = (sides - 1) / 2;
  Report report{.header = {"shorter side [edges]", "anti events, dealt [%]", "95 % half width [%]",
                           "anti events, drawn with replacement [%]",
                           "mean from here to the end, dealt [%]"}};
  std::vector<double> share(longest + 1);
  for (std::size_t length = 1; length <= longest; ++length) share[length] = 100 * dealt.share(length);
  std::size_t onset = 0;
  for (std::size_t length = 1; length <= longest; ++length) {
    std::vector<double> values;
    for (const auto& trial : dealt.anti) values.push_back(100.0 * trial[length]);
    if (onset == 0 && share[length] > 0) onset = length;
    const double rest =
        std::accumulate(share.begin() + static_cast<std::ptrdiff_t>(length), share.end(), 0.0);
    const auto half_width = estimate(values).half_width;
    report.rows.push_back({cell(std::uint64_t{length}), cell(share[length], 2),
                           half_width ? cell(*half_width, 2) : "", cell(100 * drawn.share(length), 2),
                           cell(rest / static_cast<double>(longest - length + 1), 2)});
  }
  report.notes.push_back(
      onset == 0 ? "no anti event at any length"
                 : fmt::format("first anti event at length {} (the paper: past 70 of 84)", onset));
  report.notes.push_back(
      fmt::format("at length {}: {:.1f} % (the paper: 10.4 %, or about 11 %)", longest, share[longest]));
  return report;
}

}  // namespace

Experiment polygon_experiment() {
  return {.name = "polygon",
          .summary = "F-polygon: how often the side with fewer edges of a random polygon weighs more",
          .parameters = {{"numbers", "INT", "170", "A: the weights are 1 .. A"},
                         {"sides", "INT", "169", "E: edges of the polygon"}},
          .repetitions = 1'000,
          .run = run};
}

}  // namespace thalweg::lab
