// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>

#include "core/dice.hpp"
#include "core/error.hpp"
#include "graph/grid.hpp"
#include "lab/list.hpp"
#include "lab/score.hpp"
#include "lab/timed_roads.hpp"
#include "network/read_network.hpp"

namespace thalweg::lab {
namespace {

/// Moments of a system: what the weights said, and how far hybrid then was from the optimum.
class Moments {
 public:
  Moments(std::string system, Report& report) : system_(std::move(system)), report_(report) {}

  void add(std::string moment, const Scores& scores, const std::vector<Accuracy>& all) {
    std::vector<double> optimal, excess;
    for (const Accuracy& one : all) {
      if (one.pairs == 0) continue;
      optimal.push_back(one.optimal);
      excess.push_back(one.excess);
    }
    const Estimate mean_excess = estimate(excess);
    std::vector<std::string> row{system_, std::move(moment), cell(scores.different)};
    for (const double score : {scores.eta, scores.gap, scores.eta_of_arcs, scores.variation})
      row.push_back(cell(score, 4));
    add_estimate(row, estimate(optimal), 2);
    add_estimate(row, mean_excess, 2);
    report_.rows.push_back(std::move(row));
    eta_.push_back(scores.eta);
    gap_.push_back(scores.gap);
    eta_of_arcs_.push_back(scores.eta_of_arcs);
    variation_.push_back(scores.variation);
    excess_.push_back(mean_excess.mean);
  }

  /// How well each score ranks the moments by their excess.
  void conclude() {
    std::string note =
        fmt::format("{}: rank correlation with the excess over {} moments:", system_, excess_.size());
    const auto add = [&](const char* name, const std::vector<double>& score) {
      const auto found = rank_correlation(score, excess_);
      note += fmt::format(" {} {};", name, found ? fmt::format("{:+.2f}", *found) : "none");
    };
    add("eta", eta_);
    add("(w_max - w_min) / |w|", gap_);
    add("w_max / arcs", eta_of_arcs_);
    add("variation", variation_);
    note.back() = ' ';
    report_.notes.push_back(note);
  }

 private:
  std::string system_;
  Report& report_;
  std::vector<double> eta_, gap_, eta_of_arcs_, variation_, excess_;
};

void add_grid(const Run& run, Report& report) {
  const std::uint64_t side = run.parameters.count("size");
  verify_grid(side, 400);
  const Digraph grid = grid_graph(side);
  Moments moments(fmt::format("grid {0} x {0}", side), report);
  std::vector<AccuracyScratch> scratches(run.threads);
  for (const std::uint64_t most : run.parameters.list("y", 1)) {
    for (const std::uint64_t count : run.parameters.list("weights", 1)) {
      std::vector<Accuracy> all(run.repetitions);
      std::vector<Scores> scores(run.repetitions);
      run.repeat(fmt::format("|Y| {}, N {}", most, count), [&](std::size_t repetition, std::size_t worker) {
        Dice dice(run.seed ^ (most << 20U) ^ count, repetition);
        std::vector<Millis> array(count);
        for (Millis& weight : array) weight = static_cast<Millis>(1 + dice.roll(most));
        std::vector<Millis> costs(grid.arc_count());
        for (Millis& cost : costs) cost = dice.pick(array);
        scores[repetition] = scores_of(costs);
        const VertexId source{dice.roll(grid.vertex_count())};
        all[repetition] = accuracy_from(grid, costs, source, scratches[worker]);
      });
      Scores mean;
      const auto share = 1.0 / static_cast<double>(run.repetitions);
      double different = 0;
      for (const Scores& one : scores) {
        different += share * static_cast<double>(one.different);
        mean.eta += share * one.eta;
        mean.gap += share * one.gap;
        mean.eta_of_arcs += share * one.eta_of_arcs;
        mean.variation += share * one.variation;
      }
      mean.different = static_cast<std::uint64_t>(different + 0.5);
      moments.add(fmt::format("|Y| {} N {}", most, count), mean, all);
    }
  }
  moments.conclude();
}

void add_recording(const Run& run, const std::string& net_file, const std::string& edgedata, Report& report) {
  const Network network = read_network(net_file);
  const RoadGraph roads(network, VehicleClass::passenger);
  const Digraph& turns = roads.turns();
  const TimedCosts recorded = TimedCosts::read(edgedata, network, roads);
  std::vector<VertexId> usable;
  for (std::size_t v = 0; v < turns.vertex_count(); ++v) {
    if (!turns.out(VertexId{v}).empty()) usable.emplace_back(v);
  }
  verify(!usable.empty(), fmt::format("{}: no road leads to another for passenger cars", net_file));
  Moments moments(std::filesystem::path(net_file).filename().string(), report);
  std::vector<AccuracyScratch> scratches(run.threads);
  const auto& begins = recorded.begins();
  for (std::size_t i = 0; i + 1 < begins.size(); ++i) {
    std::vector<Millis> costs(turns.arc_count());
    for (std::size_t a = 0; a < costs.size(); ++a) costs[a] = recorded(ArcId{a}, begins[i]);
    std::vector<Accuracy> all(run.repetitions);
    run.repeat(fmt::format("{} s", begins[i]), [&](std::size_t repetition, std::size_t worker) {
      Dice dice(run.seed, repetition);  // the same sources at every moment
      all[repetition] = accuracy_from(turns, costs, dice.pick(usable), scratches[worker]);
    });
    moments.add(fmt::format("{} s", begins[i]), scores_of(costs), all);
  }
  moments.conclude();
}

Report run(const Run& run) {
  const std::string& net_file = run.parameters.text("net-file");
  const std::string& edgedata = run.parameters.text("edgedata-file");
  verify(net_file.empty() == edgedata.empty(), "--net-file and --edgedata-file belong together");
  Report report{.header = {"system", "moment", "different weights", "eta = w_max / |w|",
                           "(w_max - w_min) / |w|", "w_max / arcs", "standard deviation / mean",
                           "fewest-arc path optimal [%]", "95 % half width [%]", "hybrid over optimum [%]",
                           "95 % half width, over [%]"}};
  add_grid(run, report);
  if (!net_file.empty()) add_recording(run, net_file, edgedata, report);
  report.notes.emplace_back(
      "weights of the roads in whole seconds, |w| counts each weight once; hybrid from random sources to all "
      "that they reach, against evolution");
  return report;
}

}  // namespace

Experiment live_score_experiment() {
  return {.name = "score",
          .summary = "does the paper's live score eta tell how far hybrid is from the optimum?",
          .parameters = {{"size", "INT", "10", "Side of the grid"},
                         {"y", "LIST", "10,20,50,100,200", "|Y|: the grid's weights come from 1 .. |Y|"},
                         {"weights", "LIST", "5,10,20,50,100", "N: so many are drawn for the array w"},
                         {"net-file", "FILE", "", "A network, besides the grid", 'n'},
                         {"edgedata-file", "FILE", "", "SUMO's edgeData of it with intervals (freq)"}},
          .repetitions = 100,
          .run = run};
}

}  // namespace thalweg::lab
