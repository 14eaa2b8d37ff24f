// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "core/error.hpp"
#include "graph/grid.hpp"
#include "lab/list.hpp"
#include "search/region_paths.hpp"
#include "search/simple_paths.hpp"

namespace thalweg::lab {
namespace {

constexpr double bytes_per_vertex = 1'000;  // the counts grow with the side: 400 bits at 200

void verify_not_cut(const SimplePaths& paths, std::uint64_t side, const Parameters& parameters) {
  if (!paths.cut()) return;
  throw InputError(
      fmt::format("BOTS on the {0} x {0} grid: stopped at {1} paths and {2} loops, with more to come; "
                  "--max-paths (now {3}) raises the bound, --count-only counts them without enumeration",
                  side, paths.paths(), paths.loops(), parameters.text("max-paths")));
}

/// One grid: both algorithms, enumerated (unless only counted) and counted.
class OneGrid {
 public:
  OneGrid(const Run& run, std::uint64_t side, Report& report)
      : run_(run), side_(side), report_(report), grid_(grid_graph(side)), corner_(side * side - 1) {
    partition<Direction::forward>(grid_, {&origin, 1}, regions_);
  }

  void enumerate() {
    const std::uint64_t max_paths = run_.parameters.count("max-paths", 1);
    StopWatch watch;
    SimplePaths simple(grid_, origin, corner_, {.max_paths = max_paths, .max_loops = 100 * max_paths});
    while (simple.advance()) {
      if (simple.paths() % 1'000'000 == 0)
        run_.say(fmt::format("BOTS, side {}: {} paths", side_, simple.paths()));
    }
    const double simple_ms = watch.lap_ms();
    verify_not_cut(simple, side_, run_.parameters);
    add("BOTS", "enumerated", cell(simple.paths()), cell(simple.loops()), simple_ms);

    watch.lap_ms();
    RegionPaths fewest(grid_, regions_, corner_);
    std::uint64_t paths = 0;
    while (fewest.advance()) {
      verify(++paths <= max_paths,
             fmt::format("EBOGP on the {0} x {0} grid: stopped after {1} paths and {2} visits, with more to "
                         "come; --max-paths raises the bound, --count-only counts them",
                         side_, max_paths, fewest.visits()));
    }
    add("EBOGP", "enumerated", cell(paths), cell(fewest.visits()), watch.lap_ms());
  }

  void count() {
    const std::size_t max_states = run_.parameters.count("max-states", 1);
    run_.say(fmt::format("BOTS, side {}: counting", side_));
    StopWatch watch;
    const auto paths = count_simple_paths(grid_, origin, corner_, max_states);
    const double paths_ms = watch.lap_ms();
    const auto loops = paths ? count_simple_path_loops(grid_, origin, corner_, max_states) : std::nullopt;
    if (paths) {
      add("BOTS", "counted", paths->str(), loops ? loops->str() : "", paths_ms);
    } else {
      report_.notes.push_back(
          fmt::format("side {}: BOTS not counted, that would take more than {} states (--max-states)", side_,
                      max_states));
    }
    watch.lap_ms();
    const BigCount fewest = count_region_paths(grid_, regions_, corner_);
    add("EBOGP", "counted", fewest.str(), "", watch.lap_ms());
  }

 private:
  static constexpr VertexId origin{0U};

  void add(const char* algorithm, const char* how, std::string paths, std::string loops, double ms) {
    const bool paper = side_ == 5 && std::string_view(how) == "enumerated";
    const bool bots = std::string_view(algorithm) == "BOTS";
    report_.rows.push_back({cell(side_), algorithm, how, std::move(paths), std::move(loops), cell(ms),
                            paper ? (bots ? "8512" : "70") : "", paper ? (bots ? "81598" : "252") : "",
                            paper ? (bots ? "5000" : "5.53") : ""});
  }

  const Run& run_;
  std::uint64_t side_;
  Report& report_;
  Digraph grid_;
  VertexId corner_;
  Regions regions_;
};

Report run(const Run& run) {
  Report report{.header = {"side", "algorithm", "how", "paths", "loops", "time [ms]", "paper paths",
                           "paper loops", "paper time [ms]"}};
  const auto sides = run.parameters.list("size");
  for (const std::uint64_t side : sides) verify_grid(side, bytes_per_vertex);
  for (const std::uint64_t side : sides) {
    OneGrid grid(run, side, report);
    if (!run.parameters.flag("count-only")) grid.enumerate();
    grid.count();
  }
  report.notes.emplace_back(
      "loops: steps of the depth-first search that do not end on the target (BOTS), vertices visited, the "
      "root included (EBOGP: C(2k, k) - 1)");
  return report;
}

}  // namespace

Experiment enumerate_experiment() {
  return {.name = "enumerate",
          .summary = "T-enumerate: all simple paths (BOTS) and all fewest-arc paths (EBOGP) across a grid",
          .parameters = {{"size", "LIST", "2..6", "Sides of the grids"},
                         {"max-paths", "INT", "20000000", "Enumeration ends with an error after so many"},
                         {"count-only", "BOOL", "false", "Counts without enumerating (any side)"},
                         {"max-states", "INT", "1000000", "Counting gives up beyond so many states"}},
          .run = run};
}

}  // namespace thalweg::lab
