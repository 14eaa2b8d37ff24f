// SPDX-License-Identifier: Apache-2.0
#include "search/hybrid.hpp"

#include "routing/list.hpp"
#include "routing/service_tree.hpp"

namespace thalweg {
namespace {

/// The paper's hybrid algorithm (Table 3): of the ways with the fewest turns the one of least time.
struct HybridSearch {
  Regions regions;

  void operator()(const Digraph& graph, const std::vector<Millis>& costs, VertexId destination,
                  std::span<const VertexId> origins, Tree& out) {
    partition<Direction::backward>(graph, {&destination, 1}, regions, origins);
    hybrid<Direction::backward>(
        graph, regions, [&](ArcId arc) { return costs[arc.value]; }, out);
  }
};

}  // namespace

std::unique_ptr<Strategy> make_hybrid(const StrategyOptions& options) {
  return std::make_unique<ServiceTreeStrategy<HybridSearch>>(options);
}

}  // namespace thalweg
