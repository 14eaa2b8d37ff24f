// SPDX-License-Identifier: Apache-2.0
#include "lab/score.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "report/statistics.hpp"

namespace thalweg::lab {

Scores scores_of(std::span<const Millis> weights) {
  std::vector<Millis> sorted;
  for (const Millis weight : weights) {
    if (weight < infinity) sorted.push_back(weight);
  }
  if (sorted.empty()) return {};
  const auto arcs = static_cast<double>(sorted.size());
  double sum = 0;
  double squares = 0;
  for (const Millis weight : sorted) {
    sum += static_cast<double>(weight);
    squares += static_cast<double>(weight) * static_cast<double>(weight);
  }
  const double mean = sum / arcs;
  std::sort(sorted.begin(), sorted.end());
  const auto least = static_cast<double>(sorted.front());
  const auto greatest = static_cast<double>(sorted.back());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  const auto different = static_cast<double>(sorted.size());
  return {.different = sorted.size(),
          .eta = greatest / different,
          .gap = (greatest - least) / different,
          .eta_of_arcs = greatest / arcs,
          .variation = std::sqrt(std::max(0.0, squares / arcs - mean * mean)) / mean};
}

Accuracy accuracy_from(const Digraph& graph, std::span<const Millis> costs, VertexId source,
                       AccuracyScratch& scratch) {
  const auto cost = [&costs](ArcId arc) { return costs[arc.value]; };
  auto& [regions, fewest, exact, evolve_scratch] = scratch;
  partition<Direction::forward>(graph, {&source, 1}, regions);
  hybrid<Direction::forward>(graph, regions, cost, fewest);
  exact = fewest;
  evolve<Direction::forward>(graph, regions, cost, exact, evolve_scratch);
  Accuracy out;
  for (const VertexId v : regions.order) {
    if (v == source || fewest.label[v] >= infinity) continue;
    ++out.pairs;
    out.optimal += fewest.label[v] == exact.label[v] ? 100 : 0;
    out.excess += 100 * (static_cast<double>(fewest.label[v]) / static_cast<double>(exact.label[v]) - 1);
  }
  if (out.pairs == 0) return out;
  out.optimal /= static_cast<double>(out.pairs);
  out.excess /= static_cast<double>(out.pairs);
  return out;
}

namespace {

std::vector<double> ranks_of(std::span<const double> values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> ranks(values.size());
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i + 1;
    while (end < order.size() && values[order[end]] == values[order[i]]) ++end;
    for (std::size_t k = i; k < end; ++k) ranks[order[k]] = static_cast<double>(i + end - 1) / 2;
    i = end;
  }
  return ranks;
}

}  // namespace

std::optional<double> rank_correlation(std::span<const double> a, std::span<const double> b) {
  return correlation(ranks_of(a), ranks_of(b));
}

}  // namespace thalweg::lab
