// SPDX-License-Identifier: Apache-2.0
#include "traffic/residuals.hpp"

#include <algorithm>

namespace thalweg {

Residuals::Residuals(const Network& network, const ResidualOptions& options)
    : network_(network), options_(options), residual_(network.roads.size(), 0) {}

void Residuals::refresh(const Servers& servers, const QueueForecast& forecast,
                        const MeasuredTimes& measured) {
  const double bin = to_seconds(forecast.options().bin);
  for (std::size_t i = 0; i < network_.roads.size(); ++i) {
    const RoadId road{i};
    residual_[road] = 0;
    const Passage passage = measured.passage(road);
    if (passage.vehicle_seconds <= 0) continue;
    const bool is_normal = network_.roads[road].function == RoadFunction::normal;
    const double free_flow = std::max(0.1, servers.free_flow(road));
    double model = free_flow;
    if (is_normal) {
      const auto at = std::min(forecast.options().bins - 1, static_cast<std::size_t>(free_flow / bin));
      model += forecast.wait(road, at);
    }
    const double longest = is_normal ? options_.longest_road : options_.longest_junction;
    const double seen =
        std::min(longest, passage.vehicle_seconds / std::max(passage.traversals, options_.least_traversals));
    const double weight = std::max(passage.traversals, passage.vehicle_seconds / model);
    residual_[road] = (seen - model) * weight / (weight + options_.prior);
  }
}

}  // namespace thalweg
