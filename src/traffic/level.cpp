// SPDX-License-Identifier: Apache-2.0
#include "traffic/level.hpp"

#include <algorithm>
#include <cmath>

namespace thalweg {

Level::Level(const Network& network, const LevelOptions& options)
    : options_(options), is_internal_(network.roads.size()) {
  for (std::size_t i = 0; i < network.roads.size(); ++i)
    is_internal_[RoadId{i}] = network.roads[RoadId{i}].function != RoadFunction::normal;
}

void Level::Sums::fade(double share) {
  weight *= share;
  free_flow *= share;
  over *= share;
}

void Level::learn(const Servers& servers, const QueueTable& expected, const MeasuredTimes& measured,
                  double seconds) {
  const double fading = std::exp(-seconds / options_.memory);
  for (Sums& sums : by_end_) sums.fade(fading);
  junctions_.fade(fading);
  squares_ *= fading;
  products_ *= fading;
  const double share = seconds / measured.window();  // of the window that is new
  const auto clamped = [&](double over) {
    return std::clamp(over, -options_.most_deviation, options_.most_deviation);
  };
  for (std::size_t i = 0; i < is_internal_.size(); ++i) {
    const RoadId road{i};
    const Passage passage = measured.passage(road);
    if (passage.traversals < 0.5) continue;
    const double weight = passage.traversals * share;
    const double free_flow = std::max(0.1, servers.free_flow(road));
    const double over = passage.vehicle_seconds / passage.traversals - free_flow;
    const bool is_normal = !is_internal_[road];
    Sums& sums = is_normal ? by_end_[static_cast<std::size_t>(servers.end(road))] : junctions_;
    const double seen = clamped(is_normal ? over - expected.wait_after(road, free_flow) : over);
    sums.weight += weight;
    sums.free_flow += weight * free_flow;
    sums.over += weight * seen;
    if (!is_normal) continue;
    squares_ += weight * free_flow * free_flow;
    products_ += weight * free_flow * seen;
  }
  solve();
}

/// over = (pace - 1) free flow + offset(end): the normal equations, the offsets eliminated.
void Level::solve() {
  Sums all;
  for (const Sums& sums : by_end_) {
    all.weight += sums.weight;
    all.free_flow += sums.free_flow;
  }
  junction_pace_ = std::clamp(1 + junctions_.over / (junctions_.free_flow + options_.prior), 0.8, 3.0);
  if (all.weight <= 0) return;
  const double mean = all.free_flow / all.weight;
  double left = squares_ + options_.prior * mean * mean;
  double right = products_;
  for (const Sums& sums : by_end_) {
    left -= sums.free_flow * sums.free_flow / (sums.weight + options_.prior);
    right -= sums.free_flow * sums.over / (sums.weight + options_.prior);
  }
  pace_ = std::clamp(1 + right / left, 0.8, 2.0);
  for (std::size_t end = 0; end < by_end_.size(); ++end) {
    const Sums& sums = by_end_[end];
    offsets_[end] = (sums.over - (pace_ - 1) * sums.free_flow) / (sums.weight + options_.prior);
  }
}

}  // namespace thalweg
