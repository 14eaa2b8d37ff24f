// SPDX-License-Identifier: Apache-2.0
#include "routing/cch_engine.hpp"
#include "routing/list.hpp"

namespace thalweg {
namespace {

/// Exact ways by a customizable contraction hierarchy for each class.
class CchStrategy : public Strategy {
 public:
  CchStrategy(const StrategyOptions& options, std::optional<CchMethod> forced)
      : options_(options), forced_(forced) {}

  void decide(std::span<const ClassTraffic> traffic, std::span<const Traveller> due,
              std::vector<Decision>& decisions) override {
    legs_.collect(due);
    while (engines_.size() < traffic.size()) engines_.emplace_back(options_.threads, options_.order_cache);
    for (std::size_t first = 0; first < legs_.group_count();) {
      const std::size_t vehicle_class = legs_.group(first).front().vehicle_class;
      std::size_t last = first + 1;
      while (last < legs_.group_count() && legs_.group(last).front().vehicle_class == vehicle_class) ++last;
      const ClassTraffic& seen = traffic[vehicle_class];
      engines_[vehicle_class].serve(seen.graph->turns(), seen.turn_costs, legs_, first, last, forced_);
      first = last;
    }
    legs_.decide(traffic, due, options_.rule, decisions);
  }

 private:
  StrategyOptions options_;
  std::optional<CchMethod> forced_;
  std::vector<CchEngine> engines_;  ///< by vehicle class
  Legs legs_;
};

}  // namespace

std::unique_ptr<Strategy> make_cch(const StrategyOptions& options) {
  return std::make_unique<CchStrategy>(options, std::nullopt);
}

std::unique_ptr<Strategy> make_hierarchy(const StrategyOptions& options) {
  return std::make_unique<CchStrategy>(options, CchMethod::hierarchy);
}

}  // namespace thalweg
