// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <filesystem>

#include "core/dice.hpp"
#include "core/error.hpp"
#include "graph/road_graph.hpp"
#include "lab/list.hpp"
#include "network/read_network.hpp"
#include "search/dijkstra.hpp"
#include "search/evolve.hpp"
#include "search/hybrid.hpp"
#include "sumo/configuration.hpp"

namespace thalweg::lab {
namespace {

/// Pairs whose fewest turns lie within 2^i .. 2^(i + 1) - 1.
constexpr std::size_t most_bins = 12;

struct Bin {
  std::uint64_t pairs = 0;
  std::uint64_t optimal = 0;
  double excess = 0;  ///< sum over the pairs, in %
  double worst = 0;
};

/// What one source says: its pairs by distance, and what evolution took to reach all.
struct FromSource {
  std::array<Bin, most_bins> bins{};
  double rounds = 0;
  double changed = 0;  ///< vertices whose label evolution lowered, of those reached, in %
};

struct Scratch {
  Regions regions;
  Tree hybrid;
  Tree exact;
  EvolveScratch evolve;
};

FromSource look(const Digraph& turns, const std::vector<Millis>& costs, VertexId source, Scratch& scratch) {
  const auto cost = [&costs](ArcId arc) { return costs[arc.value]; };
  auto& [regions, fewest, exact, evolve_scratch] = scratch;
  partition<Direction::forward>(turns, {&source, 1}, regions);
  hybrid<Direction::forward>(turns, regions, cost, fewest);
  exact = fewest;
  const Evolution evolution = evolve<Direction::forward>(turns, regions, cost, exact, evolve_scratch);
  FromSource out;
  out.rounds = evolution.rounds;
  std::uint64_t changed = 0;
  std::uint64_t reached = 0;
  for (const VertexId v : regions.order) {
    if (v == source || exact.label[v] >= infinity) continue;
    ++reached;
    changed += exact.label[v] < fewest.label[v] ? 1U : 0U;
    if (exact.label[v] == 0 || fewest.label[v] >= infinity) continue;
    const std::uint32_t distance = regions.number[v] - 1;
    Bin& bin = out.bins[std::min<std::size_t>(most_bins - 1,
                                              static_cast<std::size_t>(std::bit_width(distance)) - 1)];
    const double excess =
        100 * (static_cast<double>(fewest.label[v]) / static_cast<double>(exact.label[v]) - 1);
    ++bin.pairs;
    bin.optimal += fewest.label[v] == exact.label[v] ? 1U : 0U;
    bin.excess += excess;
    bin.worst = std::max(bin.worst, excess);
  }
  if (reached > 0) out.changed = 100 * static_cast<double>(changed) / static_cast<double>(reached);
  return out;
}

void add_city(const Run& run, const std::string& file, Report& report) {
  run.say(fmt::format("reading {}", file));
  const Network network = read_network(file);
  const auto vehicle_class = parse_vehicle_class(run.parameters.text("vclass"));
  verify(vehicle_class.has_value(),
         fmt::format("--vclass {}: nobody knows this vehicle class", run.parameters.text("vclass")));
  const RoadGraph roads(network, *vehicle_class);
  std::vector<Millis> costs;
  turn_costs(roads, free_flow_times(network, *vehicle_class, 55.0, {}), costs);
  std::vector<VertexId> usable;
  for (std::size_t v = 0; v < roads.turns().vertex_count(); ++v) {
    if (!roads.turns().out(VertexId{v}).empty()) usable.emplace_back(v);
  }
  verify(!usable.empty(), fmt::format("{}: no road leads to another for this class", file));

  const std::string name = std::filesystem::path(file).filename().string();
  std::vector<FromSource> all(run.repetitions);
  std::vector<Scratch> scratches(run.threads);
  run.repeat(name, [&](std::size_t repetition, std::size_t worker) {
    Dice dice(run.seed, repetition);
    all[repetition] = look(roads.turns(), costs, dice.pick(usable), scratches[worker]);
  });
  std::vector<double> rounds;
  std::vector<double> changed;
  for (const FromSource& from : all) {
    rounds.push_back(from.rounds);
    changed.push_back(from.changed);
  }
  const auto add_row = [&](const std::string& distance, const std::vector<std::size_t>& bins) {
    std::vector<double> optimal;  // by source: pairs of one source are not independent
    std::vector<double> excess;
    std::uint64_t pairs = 0;
    double worst = 0;
    for (const FromSource& from : all) {
      Bin sum;
      for (const std::size_t b : bins) {
        sum.pairs += from.bins[b].pairs;
        sum.optimal += from.bins[b].optimal;
        sum.excess += from.bins[b].excess;
        worst = std::max(worst, from.bins[b].worst);
      }
      if (sum.pairs == 0) continue;
      pairs += sum.pairs;
      optimal.push_back(100 * static_cast<double>(sum.optimal) / static_cast<double>(sum.pairs));
      excess.push_back(sum.excess / static_cast<double>(sum.pairs));
    }
    if (pairs == 0) return;
    std::vector<std::string> row{name, cell(std::uint64_t{usable.size()}), distance, cell(pairs)};
    add_estimate(row, estimate(optimal), 1);
    add_estimate(row, estimate(excess), 2);
    row.push_back(cell(worst, 1));
    const bool whole = bins.size() == most_bins;
    if (whole) {
      add_estimate(row, estimate(rounds), 1);
      add_estimate(row, estimate(changed), 1);
    } else {
      row.insert(row.end(), 4, "");
    }
    report.rows.push_back(std::move(row));
  };
  std::vector<std::size_t> every;
  for (std::size_t b = 0; b < most_bins; ++b) {
    add_row(fmt::format("{}-{}", 1U << b, (2U << b) - 1), {b});
    every.push_back(b);
  }
  add_row("all", every);
}

Report run(const Run& run) {
  Report report{.header = {"network", "roads", "turns apart", "pairs", "fewest-turn path optimal [%]",
                           "95 % half width [%]", "excess, mean [%]", "95 % half width, excess [%]",
                           "excess, greatest [%]", "evolution rounds, mean", "95 % half width, rounds",
                           "labels lowered [%]", "95 % half width, lowered [%]"}};
  const auto files = file_list(run.parameters.text("net-file"));
  verify(!files.empty(), "no network: name some with --net-file a.net.xml,b.net.xml.gz");
  for (const std::string& file : files) add_city(run, file, report);
  report.notes.emplace_back(
      "from random roads to every road they reach, at free flow; turns apart: the fewest turns between them");
  return report;
}

}  // namespace

Experiment city_regions_experiment() {
  return {.name = "city-regions",
          .summary = "how often the path with the fewest turns is the best one on real road networks",
          .parameters = {{"net-file", "FILE", "", "Road networks, by comma", 'n'},
                         {"vclass", "STR", "passenger", "Vehicle class"}},
          .repetitions = 200,
          .run = run};
}

}  // namespace thalweg::lab
