// SPDX-License-Identifier: Apache-2.0
#include "traffic/lived_times.hpp"

#include <algorithm>
#include <utility>

namespace thalweg {
namespace {

constexpr double least_traversals = 0.5;

}  // namespace

LivedTimes::LivedTimes(const Network& network, Millis bin)
    : network_(network), bin_(bin), open_(network.roads.size()) {}

void LivedTimes::look(std::span<const Observation> vehicles, Millis now) {
  const auto bin = static_cast<std::size_t>(std::max<Millis>(0, now) / bin_);
  if (bin != at_) close_bin();
  at_ = bin;
  const double since = last_look_ < 0 ? 0 : to_seconds(now - last_look_);
  last_look_ = now;
  for (const Observation& vehicle : vehicles) {
    if (!vehicle.road.valid()) continue;
    Passage& passage = open_[vehicle.road];
    if (passage.vehicle_seconds <= 0) seen_.push_back(vehicle.road);
    passage.vehicle_seconds += since;
    const double length = network_.lanes[network_.roads[vehicle.road].first_lane].length;
    if (length > 0) passage.traversals += vehicle.speed * since / length;
  }
}

std::vector<std::vector<LivedTime>> LivedTimes::take() {
  close_bin();
  return std::exchange(closed_, {});
}

void LivedTimes::close_bin() {
  if (closed_.size() <= at_) closed_.resize(at_ + 1);
  std::sort(seen_.begin(), seen_.end());
  seen_.erase(std::unique(seen_.begin(), seen_.end()), seen_.end());
  for (const RoadId road : seen_) {
    const Passage passage = std::exchange(open_[road], {});
    const bool is_standstill = passage.vehicle_seconds >= to_seconds(bin_) / 2;
    if (passage.traversals < least_traversals && !is_standstill) continue;
    closed_[at_].push_back(
        {.road = road,
         .seconds = passage.vehicle_seconds / std::max(passage.traversals, least_traversals),
         .observations = passage.traversals});
  }
  seen_.clear();
}

}  // namespace thalweg
