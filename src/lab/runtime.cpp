// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <sys/resource.h>

#include <array>
#include <cmath>
#include <optional>

#include "core/dice.hpp"
#include "core/error.hpp"
#include "graph/grid.hpp"
#include "lab/boost_dijkstra.hpp"
#include "lab/list.hpp"
#include "search/dijkstra.hpp"
#include "search/evolve.hpp"
#include "search/hybrid.hpp"
#include "search/hybrid_in_one_pass.hpp"

namespace thalweg::lab {
namespace {

/// Digraph 120, costs 16, labels and tables 90, Boost's graph and its heap 120; measured 250 at side 2,000.
constexpr double bytes_per_vertex = 400;

/// The paper's table: side, G.P., E., total. It says microseconds; they can only be milliseconds.
struct PaperRow {
  std::uint64_t side;
  double partition, exploring, total;
};
constexpr std::array<PaperRow, 10> paper{{{20, 3.21, 4.45, 7.66},
                                          {40, 9.77, 15.37, 25.14},
                                          {60, 21.57, 34.77, 56.34},
                                          {80, 45.55, 67.57, 113.12},
                                          {100, 68.51, 115.09, 183.6},
                                          {120, 99.13, 163.73, 262.86},
                                          {140, 132.57, 223.95, 356.52},
                                          {160, 180.15, 301.155, 481.3},
                                          {180, 231.44, 384.49, 615.93},
                                          {200, 274.44, 474.58, 749.02}}};

/// A textbook breadth-first search over the same arrays: the least that any search must do.
struct BreadthFirst {
  IdVector<VertexId, std::uint32_t> distance;
  IdVector<VertexId, VertexId> parent;
  std::vector<VertexId> queue;

  void run(const Digraph& graph, VertexId source) {
    constexpr auto unseen = std::numeric_limits<std::uint32_t>::max();
    distance.assign(graph.vertex_count(), unseen);
    parent.assign(graph.vertex_count(), VertexId{});
    queue.clear();
    queue.reserve(graph.vertex_count());
    queue.push_back(source);
    distance[source] = 0;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const VertexId u = queue[i];
      for (const Arc& arc : graph.out(u)) {
        if (distance[arc.end] != unseen) continue;
        distance[arc.end] = distance[u] + 1;
        parent[arc.end] = u;
        queue.push_back(arc.end);
      }
    }
  }
};

struct Times {
  std::vector<double> partition, hybrid, one_pass, breadth_first, boost, dijkstra, evolution;
};

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// The time of the second of two calls: each engine finds the caches as it leaves them itself, not as another
/// one does.
template <class Engine>
double second_ms(const Engine& engine) {
  engine();
  StopWatch watch;
  engine();
  return watch.lap_ms();
}

bool agree(const MarkedRegions& at_once, const Regions& regions, const Tree& tree) {
  for (const VertexId v : regions.order) {
    const auto& mark = at_once.marks[v];
    if (mark.label != tree.label[v] || mark.parent != tree.parent[v] || mark.number != regions.number[v])
      return false;
  }
  return at_once.order == regions.order && at_once.first == regions.first;
}

/// Every engine in turn, `repetitions` times, on storage that stays; they must agree.
Times measure(const Run& run, std::uint64_t side, const Digraph& grid,
              const std::vector<std::int32_t>& costs) {
  const auto cost = [&costs](ArcId arc) { return Millis{costs[arc.value]}; };
  const VertexId origin{0U};
  const std::span sources(&origin, 1);
  BreadthFirst breadth_first;
  Regions regions;
  Tree tree;
  Tree exact;
  MarkedRegions at_once;
  DijkstraScratch dijkstra_scratch;
  EvolveScratch evolve_scratch;
  BoostDijkstra boost(grid, costs);
  const bool evolved = side <= run.parameters.count("evolution-max");
  Times times;
  for (std::size_t i = 0; i < run.repetitions; ++i) {
    run.say(fmt::format("side {}: {} of {}", side, i, run.repetitions));
    times.breadth_first.push_back(second_ms([&] { breadth_first.run(grid, origin); }));
    times.partition.push_back(second_ms([&] { partition<Direction::forward>(grid, sources, regions); }));
    times.hybrid.push_back(second_ms([&] { hybrid<Direction::forward>(grid, regions, cost, tree); }));
    times.one_pass.push_back(
        second_ms([&] { partition_and_hybrid<Direction::forward>(grid, sources, cost, at_once); }));
    verify(agree(at_once, regions, tree),
           fmt::format("side {}: hybrid in one pass and in two disagree", side));
    if (evolved) {
      StopWatch watch;
      evolve<Direction::forward>(grid, regions, cost, tree, evolve_scratch);
      times.evolution.push_back(watch.lap_ms());
    }
    times.dijkstra.push_back(
        second_ms([&] { dijkstra<Direction::forward>(grid, sources, cost, exact, dijkstra_scratch); }));
    times.boost.push_back(second_ms([&] { boost.run(origin); }));
    const bool exact_agree = std::equal(exact.label.begin(), exact.label.end(), boost.labels().begin()) &&
                             (!evolved || exact.label == tree.label);
    verify(exact_agree, fmt::format("side {}: evolution, Dijkstra and Boost's Dijkstra disagree", side));
  }
  return times;
}

/// The exponent of the side in the time: the slope of log(time) over log(side), by least squares.
std::optional<double> exponent(const std::vector<std::pair<double, double>>& points) {
  if (points.size() < 2) return std::nullopt;
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& [side, time] : points) {
    x += std::log(side);
    y += std::log(time);
    xx += std::log(side) * std::log(side);
    xy += std::log(side) * std::log(time);
  }
  const auto n = static_cast<double>(points.size());
  return (n * xy - x * y) / (n * xx - x * x);
}

Report run(const Run& run) {
  Report report{.header = {"side",
                           "vertices",
                           "arcs",
                           "partition [ms]",
                           "hybrid [ms]",
                           "both in one pass [ms]",
                           "breadth-first [ms]",
                           "Boost Dijkstra [ms]",
                           "Dijkstra [ms]",
                           "evolution [ms]",
                           "one pass / breadth-first",
                           "one pass / Boost Dijkstra",
                           "two passes / Boost Dijkstra",
                           "table operations",
                           "operations / arc",
                           "first form [ms]",
                           "first form comparisons",
                           "peak memory [MB]",
                           "paper partition [ms]",
                           "paper exploring [ms]",
                           "paper total [ms]"}};
  const auto sides = run.parameters.list("size");
  const std::uint64_t first_form_max = run.parameters.count("first-form-max");
  for (const std::uint64_t side : sides) verify_grid(side, bytes_per_vertex);
  std::vector<std::pair<double, double>> points;
  for (const std::uint64_t side : sides) {
    const Digraph grid = grid_graph(side);
    const VertexId origin{0U};
    Dice dice(run.seed, side);
    std::vector<std::int32_t> costs(grid.arc_count());
    for (auto& c : costs) c = static_cast<std::int32_t>(1 + dice.roll(side));
    const Times times = measure(run, side, grid, costs);

    Regions regions;
    PartitionOperations operations;
    partition<Direction::forward>(grid, {&origin, 1}, regions, operations);
    std::vector<std::string> row{cell(side), cell(grid.vertex_count()), cell(grid.arc_count())};
    const double one_pass = median(times.one_pass);
    const double two_passes = median(times.partition) + median(times.hybrid);
    const double breadth_first = median(times.breadth_first);
    const double boost = median(times.boost);
    for (const double value : {median(times.partition), median(times.hybrid), one_pass, breadth_first, boost,
                               median(times.dijkstra), median(times.evolution), one_pass / breadth_first,
                               one_pass / boost, two_passes / boost}) {
      row.push_back(cell(value));
    }
    row.push_back(cell(operations.table));
    row.push_back(cell(static_cast<double>(operations.table) / static_cast<double>(grid.arc_count())));
    points.emplace_back(static_cast<double>(side), one_pass);
    if (side <= first_form_max) {
      PartitionOperations first;
      StopWatch watch;
      partition_first_form<Direction::forward>(grid, {&origin, 1}, regions, 0, &first);
      row.push_back(cell(watch.lap_ms()));
      row.push_back(cell(first.comparisons));
    } else {
      row.insert(row.end(), 2, "");
    }
    row.push_back(cell(peak_megabytes(), 0));
    const auto known =
        std::find_if(paper.begin(), paper.end(), [&](const auto& p) { return p.side == side; });
    const PaperRow paper_row = known == paper.end() ? PaperRow{0, NAN, NAN, NAN} : *known;
    for (const double value : {paper_row.partition, paper_row.exploring, paper_row.total})
      row.push_back(cell(value));
    report.rows.push_back(std::move(row));
  }
  if (const auto slope = exponent(points)) {
    report.notes.push_back(
        fmt::format("time of the one pass grows as side^{:.2f} (the paper: quadratic)", *slope));
  }
  report.notes.emplace_back(
      "times: CPU time of one thread, medians over the repetitions, each engine right after a run of its "
      "own; "
      "all storage but Boost's heap and colours is reused");
  return report;
}

}  // namespace

Experiment runtime_experiment() {
  return {.name = "runtime",
          .summary = "T-runtime: partition and hybrid on grids, against breadth-first search and Dijkstra",
          .parameters = {{"size", "LIST", "20..200/20,500,1000,2000", "Sides of the grids"},
                         {"first-form-max", "INT", "500", "The partition's first form up to this side"},
                         {"evolution-max", "INT", "500", "Evolution up to this side"}},
          .repetitions = 5,
          .run = run};
}

}  // namespace thalweg::lab
