// SPDX-License-Identifier: Apache-2.0
#include "traffic/measured.hpp"

#include <algorithm>
#include <cmath>

namespace thalweg {

MeasuredTimes::MeasuredTimes(const Network& network, Millis window, Millis interval)
    : limit_(network.roads.size()),
      length_(network.roads.size()),
      deviation_(network.roads.size(), 0),
      seen_(network.roads.size()),
      interval_(to_seconds(interval)),
      ring_(static_cast<std::size_t>(std::max<Millis>(1, window / interval))),
      speeds_(network.roads.size()) {
  for (std::size_t i = 0; i < network.roads.size(); ++i) {
    const Road& road = network.roads[RoadId{i}];
    double speed = 0;
    for (const LaneId lane : road.lanes()) speed = std::max(speed, network.lanes[lane].speed);
    limit_[RoadId{i}] = static_cast<std::int32_t>(std::lround(std::min(speed, 1e5) * 1000.0));
    length_[RoadId{i}] = std::llround(network.lanes[road.first_lane].length * 1000.0);
  }
}

void MeasuredTimes::sample(std::span<const Observation> vehicles) {
  std::vector<Entry>& entries = ring_[slot_];
  slot_ = (slot_ + 1) % ring_.size();
  for (const Entry& old : entries) {
    deviation_[old.road] -= old.deviation;
    seen_[old.road].sum -= old.speeds.sum;
    seen_[old.road].count -= old.speeds.count;
  }
  entries.clear();
  for (const Observation& vehicle : vehicles) {
    if (!vehicle.road.valid()) continue;
    Speeds& speeds = speeds_[vehicle.road];
    if (speeds.count++ == 0) entries.push_back({.road = vehicle.road});
    speeds.sum += std::llround(vehicle.speed * 1000.0);
  }
  for (Entry& entry : entries) {
    Speeds& speeds = speeds_[entry.road];
    entry.deviation = static_cast<std::int32_t>(speeds.sum / speeds.count - limit_[entry.road]);
    deviation_[entry.road] += entry.deviation;
    entry.speeds = speeds;
    seen_[entry.road].sum += speeds.sum;
    seen_[entry.road].count += speeds.count;
    speeds = {};
  }
}

void MeasuredTimes::live(const RoadTimes& free_flow, RoadTimes& out) const {
  out = free_flow;
  const auto samples = static_cast<std::int64_t>(ring_.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const RoadId road{i};
    if (deviation_[road] >= 0) continue;
    // One mm/s at the least: a road that stood still for the whole window is slow, not closed.
    const std::int64_t speed = std::max<std::int64_t>(1, limit_[road] + deviation_[road] / samples);
    out[road] = std::max(out[road], length_[road] * 1000 / speed);
  }
}

}  // namespace thalweg
