// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "lab/dynamic_grid.hpp"
#include "lab/experiment.hpp"

namespace thalweg::lab {

/// The paper's figures of a set of tests in the dynamical system.
class Rankings {
 public:
  explicit Rankings(std::vector<DynamicGrid::Position> all) : all_(std::move(all)) {}

  static std::vector<std::string> header() {
    return {"top [%]",          "worst position [%]", "average status [%]",
            "mean position",    "95 % half width",    "mean distinct totals",
            "95 % half width ", "commonest position", "hybrid over optimum [%]"};
  }
  /// The cells under `header`.
  void add_to(std::vector<std::string>& row) const {
    std::vector<double> positions, distinct, excess;
    std::uint64_t top = 0;
    double worst = 0;
    for (const auto& p : all_) {
      positions.push_back(static_cast<double>(p.position));
      distinct.push_back(static_cast<double>(p.distinct));
      excess.push_back(p.optimal == 0 ? 0
                                      : 100.0 * static_cast<double>(p.hybrid - p.optimal) /
                                            static_cast<double>(p.optimal));
      top += p.position == 1 ? 1U : 0U;
      // one total only: hybrid has it, and is not at the bottom of anything
      if (p.distinct > 1) worst = std::max(worst, 100 * positions.back() / distinct.back());
    }
    const Estimate position = estimate(positions);
    const Estimate totals = estimate(distinct);
    row.push_back(cell(100 * static_cast<double>(top) / static_cast<double>(all_.size()), 1));
    row.push_back(cell(worst, 1));
    row.push_back(cell(100 * position.mean / totals.mean, 2));
    add_estimate(row, position, 2);
    add_estimate(row, totals, 1);
    row.push_back(cell(commonest()));
    row.push_back(cell(estimate(excess).mean, 2));
  }
  [[nodiscard]] bool all_on_top() const {
    return std::all_of(all_.begin(), all_.end(), [](const auto& p) { return p.position == 1; });
  }

 private:
  [[nodiscard]] std::uint64_t commonest() const {
    std::vector<std::uint64_t> positions;
    for (const auto& p : all_) positions.push_back(p.position);
    std::sort(positions.begin(), positions.end());
    std::uint64_t best = 0;
    std::size_t most = 0;
    for (auto at = positions.begin(); at != positions.end();) {
      const auto next = std::upper_bound(at, positions.end(), *at);
      if (static_cast<std::size_t>(next - at) > most) {
        most = static_cast<std::size_t>(next - at);
        best = *at;
      }
      at = next;
    }
    return best;
  }
  std::vector<DynamicGrid::Position> all_;
};

/// 1 x gap, 2 x gap .. count x gap.
inline std::vector<std::int64_t> even_array(std::uint64_t count, std::int64_t gap) {
  std::vector<std::int64_t> out;
  for (std::uint64_t i = 1; i <= count; ++i) out.push_back(gap * static_cast<std::int64_t>(i));
  return out;
}

/// InputError when the side is no grid's, or its pairs would not fit.
inline void verify_dynamic(std::uint64_t side, std::size_t threads) {
  verify_grid(side, 400);
  verify_memory("the weight tables", static_cast<double>(threads) * DynamicGrid::bytes(side));
}

}  // namespace thalweg::lab
