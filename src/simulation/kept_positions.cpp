// SPDX-License-Identifier: Apache-2.0
#include "simulation/kept_positions.hpp"

#include <algorithm>

namespace thalweg {

std::vector<std::size_t> kept_positions(const Plan& plan, std::span<const RoadId> via) {
  std::vector<std::size_t> kept{plan.route.size() - 1};
  std::size_t from = 0;
  for (const RoadId stop : plan.stops) {
    const auto found =
        std::find(plan.route.begin() + static_cast<std::ptrdiff_t>(from), plan.route.end(), stop);
    if (found == plan.route.end()) return {};
    from = static_cast<std::size_t>(found - plan.route.begin());
    kept.push_back(from);
  }
  // The route ahead holds the last few of `via`: they are matched from its end, the first that fails is
  // behind us.
  auto end = plan.route.rend();
  auto position = plan.route.rbegin();
  for (std::size_t i = via.size(); i-- > 0;) {
    position = std::find(position, end, via[i]);
    if (position == end) break;
    kept.push_back(static_cast<std::size_t>(end - position) - 1);
  }
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  return kept;
}

}  // namespace thalweg
