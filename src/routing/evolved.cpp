// SPDX-License-Identifier: Apache-2.0
#include "routing/list.hpp"
#include "routing/service_tree.hpp"
#include "search/evolve.hpp"
#include "search/hybrid.hpp"

namespace thalweg {
namespace {

/// The paper's evolutionary hybrid: the hybrid's tree, improved until nothing changes. It is exact.
struct EvolvedSearch {
  Regions regions;
  EvolveScratch scratch;

  void operator()(const Digraph& graph, const std::vector<Millis>& costs, VertexId destination,
                  std::span<const VertexId> origins, Tree& out) {
    const auto cost = [&](ArcId arc) { return costs[arc.value]; };
    partition<Direction::backward>(graph, {&destination, 1}, regions, origins);
    hybrid<Direction::backward>(graph, regions, cost, out);
    [[maybe_unused]] const Evolution evolution =
        evolve<Direction::backward>(graph, regions, cost, out, scratch, {}, origins);
    assert(evolution.settled);  // costs are >= 0: as many rounds as vertices always suffice
  }
};

}  // namespace

std::unique_ptr<Strategy> make_evolved(const StrategyOptions& options) {
  return std::make_unique<ServiceTreeStrategy<EvolvedSearch>>(options);
}

}  // namespace thalweg
