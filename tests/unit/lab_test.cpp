// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "core/dice.hpp"
#include "core/error.hpp"
#include "graph/grid.hpp"
#include "lab/dissection.hpp"
#include "lab/dynamic_grid.hpp"
#include "lab/experiment.hpp"
#include "lab/families.hpp"
#include "lab/weights.hpp"

namespace thalweg::lab {
namespace {

std::string message_of(auto&& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// An experiment with its defaults, but for what is given.
Report run(std::string_view name, std::map<std::string, std::string, std::less<>> values,
           std::size_t repetitions = 5, std::size_t threads = 1, std::uint64_t seed = 1) {
  const Experiment& experiment = find_experiment(name);
  for (const Parameter& parameter : experiment.parameters)
    values.try_emplace(parameter.name, parameter.default_value);
  return experiment.run({.parameters = Parameters(std::move(values)),
                         .seed = seed,
                         .repetitions = repetitions,
                         .threads = threads,
                         .progress = {}});
}

std::string at(const Report& report, std::size_t row, std::string_view column) {
  const auto found = std::find(report.header.begin(), report.header.end(), column);
  return report.rows.at(row).at(static_cast<std::size_t>(found - report.header.begin()));
}

TEST(Parameters, ReadNumbersRangesAndSayWhatIsWrong) {
  const auto list = [](std::string text, std::uint64_t least = 0) {
    return Parameters({{"size", std::move(text)}}).list("size", least);
  };
  EXPECT_EQ(list("5"), (std::vector<std::uint64_t>{5}));
  EXPECT_EQ(list("2..4, 20..61/20"), (std::vector<std::uint64_t>{2, 3, 4, 20, 40, 60}));
  EXPECT_NE(message_of([&] { list("x"); }).find("--size x"), std::string::npos);
  EXPECT_NE(message_of([&] { list("4..2"); }), "");
  EXPECT_NE(message_of([&] { list("1..9/0"); }), "");
  EXPECT_NE(message_of([&] { list("1..900000000"); }), "");
  EXPECT_NE(message_of([&] { list(""); }), "");
  EXPECT_NE(message_of([&] { list("2", 3); }), "");
}

TEST(Experiments, HaveDifferentNamesAndAreFoundByThem) {
  std::set<std::string> names;
  for (const Experiment& experiment : experiments()) {
    EXPECT_TRUE(names.insert(experiment.name).second);
    EXPECT_EQ(&find_experiment(experiment.name), &experiment);
    EXPECT_FALSE(experiment.summary.empty());
  }
  EXPECT_NE(message_of([] { (void)find_experiment("enumerat"); }).find("did you mean 'enumerate'"),
            std::string::npos);
}

TEST(Experiments, RefuseGridsThatAreNoneOrDoNotFit) {
  for (const char* name : {"enumerate", "runtime", "greedy", "evolve", "dynamic", "density", "regular",
                           "crew", "memory", "score"}) {
    for (const char* side : {"0", "1"})
      EXPECT_NE(message_of([&] { run(name, {{"size", side}}); }).find("side"), std::string::npos) << name;
    EXPECT_NE(message_of([&] { run(name, {{"size", "1000000"}}); }).find("GB"), std::string::npos) << name;
  }
}

// Those without a clock in their table: the same for any number of threads, another one for another seed.
TEST(Experiments, DoNotDependOnTheNumberOfThreads) {
  using Values = std::map<std::string, std::string, std::less<>>;
  const std::vector<std::pair<const char*, Values>> small{{"polygon", {{"numbers", "20"}, {"sides", "19"}}},
                                                          {"triangle", {{"n", "10"}}},
                                                          {"greedy", {{"size", "6"}}},
                                                          {"dynamic", {{"size", "4"}, {"weights", "10"}}},
                                                          {"density", {{"size", "4"}, {"weights", "10"}}},
                                                          {"regular", {{"size", "4"}, {"y", "5"}}},
                                                          {"evolve", {{"size", "6"}}},
                                                          {"evolve-rounds", {{"vertices", "30"}}},
                                                          {"score", {{"size", "5"}, {"y", "9"}}},
                                                          {"crew", {{"size", "4"}}},
                                                          {"memory", {{"size", "4"}, {"vehicles", "3"}}}};
  for (const auto& [name, values] : small) {
    const std::string one = run(name, values, 9, 1).csv();
    EXPECT_EQ(one, run(name, values, 9, 3).csv()) << name;
    EXPECT_NE(one, run(name, values, 9, 1, 2).csv()) << name;
  }
}

TEST(Enumerate, PrintsThePapersFigures) {
  const Report report = run("enumerate", {{"size", "5"}});
  ASSERT_EQ(report.rows.size(), 4U);
  EXPECT_EQ(at(report, 0, "paths"), "8512");
  EXPECT_EQ(at(report, 0, "loops"), "81598");
  EXPECT_EQ(at(report, 1, "paths"), "70");
  EXPECT_EQ(at(report, 2, "paths"), "8512");
  EXPECT_EQ(at(report, 2, "loops"), "81598");
  EXPECT_EQ(at(report, 3, "paths"), "70");
}

TEST(Enumerate, EndsWithTheCountSoFar) {
  const std::string message = message_of([] { run("enumerate", {{"size", "6"}, {"max-paths", "1000"}}); });
  EXPECT_NE(message.find("1000 paths"), std::string::npos) << message;
  EXPECT_NE(message.find("--max-paths"), std::string::npos);
  const Report counted = run("enumerate", {{"size", "7"}, {"count-only", "true"}});
  EXPECT_EQ(at(counted, 0, "paths"), "575780564");
}

TEST(Runtime, CountsAndAgreesWithBoost) {
  const Report report = run("runtime", {{"size", "20,30"}}, 2);
  EXPECT_EQ(at(report, 0, "arcs"), "1520");
  EXPECT_EQ(at(report, 0, "paper total [ms]"), "7.660");
  EXPECT_EQ(at(report, 1, "paper total [ms]"), "");
  EXPECT_LE(std::stod(at(report, 0, "operations / arc")), 4);
  EXPECT_GT(std::stod(at(report, 0, "operations / arc")), 1);
}

TEST(Triangle, ExactShareEqualsCountingTriples) {
  constexpr int n = 20;
  double anti = 0;
  double all = 0;
  for (int a = 1; a <= n; ++a) {
    for (int b = a + 1; b <= n; ++b) {
      for (int c = b + 1; c <= n; ++c) {
        ++all;
        anti += a + b < c ? 1 : 0;
      }
    }
  }
  EXPECT_NEAR(std::stod(at(run("triangle", {{"n", "20"}}), 0, "x1 + x2 < y, exact")), anti / all, 5e-5);
}

// w_i = c i multiplies every total by c: no rank moves.
TEST(Density, DoesNothingAsThePaperDefinesIt) {
  const Report report =
      run("density", {{"size", "5"}, {"weights", "20"}, {"gap", "1,4"}, {"reading", "table"}}, 20);
  for (const char* column : {"top [%]", "average status [%]", "mean distinct totals"})
    EXPECT_EQ(at(report, 0, column), at(report, 1, column)) << column;
}

TEST(AssignmentArray, HasItsShape) {
  Dice dice(1);
  const auto spread = [&](const char* name) {  // share of the range that the middle half of them takes
    const auto array = assignment_array(name, 40, dice);
    EXPECT_EQ(array.size(), 40U);
    EXPECT_TRUE(std::is_sorted(array.begin(), array.end()));
    EXPECT_GE(array.front(), 1);
    return static_cast<double>(array[29] - array[10]) / static_cast<double>(array[39] - array[0]);
  };
  EXPECT_NEAR(spread("regular"), 0.5, 0.05);
  EXPECT_LT(spread("normal"), 0.4);
  EXPECT_GT(spread("dumbbell"), 0.6);
  EXPECT_NEAR(spread("gaps"), 0.5, 0.15);
  EXPECT_NE(message_of([&] { (void)assignment_array("norml", 4, dice); }).find("'normal'"),
            std::string::npos);
}

TEST(DissectionOrder, HasEveryVertexOnceAndCutsLast) {
  const Digraph grid = grid_graph(9);
  auto order = dissection_order(grid);
  std::vector<std::size_t> rank(81);
  for (std::size_t i = 0; i < order.size(); ++i) rank[order[i].value] = i;
  std::sort(order.begin(), order.end());
  ASSERT_EQ(order.size(), 81U);
  EXPECT_EQ(std::unique(order.begin(), order.end()), order.end());
  // Without the last quarter the grid falls apart: no vertex left reaches more than half of it.
  std::vector<ArcEnds> left;
  for (std::size_t a = 0; a < grid.arc_count(); ++a) {
    const auto [tail, head] = grid.ends(ArcId{a});
    if (rank[tail.value] < 61 && rank[head.value] < 61) left.push_back({.tail = tail, .head = head});
  }
  const Digraph rest(81, left);
  Regions regions;
  for (std::size_t v = 0; v < 81; ++v) {
    const VertexId source{v};
    partition<Direction::forward>(rest, {&source, 1}, regions);
    EXPECT_LT(regions.order.size(), 41U);
  }
  EXPECT_TRUE(dissection_order(Digraph{}).empty());
}

TEST(Dice, AreFairAndDifferInEveryStream) {
  Dice dice(5, 7);
  std::array<int, 6> sides{};
  for (int i = 0; i < 60'000; ++i) ++sides[dice.roll(6)];
  for (const int count : sides) EXPECT_NEAR(count, 10'000, 400);
  std::set<std::uint64_t> firsts;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    for (std::uint64_t stream = 0; stream < 30; ++stream) firsts.insert(Dice(seed, stream).next());
  }
  EXPECT_EQ(firsts.size(), 900U);
}

TEST(Report, WritesCsv) {
  const Report report{.header = {"a", "b [ms]"}, .rows = {{"x, \"y\"", ""}, {"", "2"}}};
  EXPECT_EQ(report.csv(), "a,b [ms]\n\"x, \"\"y\"\"\",\n,2\n");
}

}  // namespace
}  // namespace thalweg::lab
