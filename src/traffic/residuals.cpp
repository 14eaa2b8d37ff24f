// SPDX-License-Identifier: Apache-2.0
#include "traffic/residuals.hpp"

#include <algorithm>
#include <cmath>

namespace thalweg {

Residuals::Residuals(const Network& network, const ResidualOptions& options)
    : network_(network),
      options_(options),
      sums_(network.roads.size()),
      lasting_(network.roads.size(), 0),
      passing_(network.roads.size(), 0) {}

void Residuals::learn(const Servers& servers, const Level& level, const QueueTable& expected,
                      const MeasuredTimes& measured, double seconds) {
  const double fading = std::exp(-seconds / options_.memory);
  const double share = seconds / measured.window();  // of the window that is new
  for (std::size_t i = 0; i < network_.roads.size(); ++i) {
    const RoadId road{i};
    Sums& sums = sums_[road];
    sums = {.weight = sums.weight * fading, .over = sums.over * fading};
    passing_[road] = 0;
    const Passage passage = measured.passage(road);
    if (passage.vehicle_seconds <= 0) continue;
    const bool is_normal = network_.roads[road].function == RoadFunction::normal;
    const double free_flow = std::max(0.1, servers.free_flow(road));
    double model = std::max(0.1, free_flow + level.extra(servers, road));
    if (is_normal) model += expected.wait_after(road, free_flow);
    const double longest = is_normal ? options_.longest_road : options_.longest_junction;
    const double seen =
        std::min(longest, passage.vehicle_seconds / std::max(passage.traversals, options_.least_traversals));
    const double weight = std::max(passage.traversals, passage.vehicle_seconds / model);
    sums.weight += weight * share;
    sums.over += weight * share * std::clamp(seen - model, -options_.most_lasting, options_.most_lasting);
    lasting_[road] = sums.over / (sums.weight + options_.prior);
    passing_[road] = (seen - model - lasting_[road]) * weight / (weight + options_.prior);
  }
}

}  // namespace thalweg
