// SPDX-License-Identifier: Apache-2.0
#include "traffic/queue_table.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace thalweg {
namespace {

/// What each turn's best lane takes when nobody is there, in the mean over the turns of the motor traffic.
double lone_wait(const Servers& servers, RoadId road) {
  double sum = 0;
  int count = 0;
  for (std::size_t m = servers.first_of(road); m < servers.last_of(road); ++m) {
    const auto lanes = servers.lanes(MovementId{m});
    if (!servers.carries(lanes.front())) continue;
    double least = std::numeric_limits<double>::infinity();
    for (const LaneId lane : lanes) least = std::min(least, servers.means(lane).delay);
    sum += least;
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

}  // namespace

QueueTable::QueueTable(const Network& network, Millis bin, std::size_t bins, bool with_tolls)
    : network_(network),
      bin_(bin),
      bins_(bins),
      wait_(network.roads.size() * bins, 0.0F),
      arrivals_(network.roads.size() * bins, 0.0F),
      toll_(with_tolls ? network.roads.size() * bins : 0, 0.0F),
      headway_(network.roads.size(), 0),
      delay_(network.roads.size(), 0),
      is_empty_(network.roads.size(), true),
      lane_{.wait = std::vector<float>(bins), .toll = std::vector<float>(bins)} {}

void QueueTable::tabulate(const Servers& servers, const Discharge& discharge,
                          const IdVector<LaneId, std::vector<Passed>>& passed) {
  for (std::size_t i = 0; i < network_.roads.size(); ++i) {
    if (network_.roads[RoadId{i}].function == RoadFunction::normal)
      tabulate_road(servers, discharge, RoadId{i}, passed);
  }
}

void QueueTable::tabulate_road(const Servers& servers, const Discharge& discharge, RoadId road,
                               const IdVector<LaneId, std::vector<Passed>>& passed) {
  const std::span<float> waits(wait_.data() + at(road, 0), bins_);
  const std::span<float> tolls =
      toll_.empty() ? std::span<float>() : std::span(toll_).subspan(at(road, 0), bins_);
  const std::span<float> arrivals(arrivals_.data() + at(road, 0), bins_);
  const Road& own = network_.roads[road];
  double rate = 0;
  std::size_t total = 0;
  for (const LaneId lane : own.lanes()) {
    const double headway = servers.means(lane).headway * discharge.factor(lane);
    if (headway > 0 && servers.carries(lane)) rate += 1 / headway;
    total += passed[lane].size();
  }
  headway_[road] = rate > 0 ? 1 / rate : 0;
  const double before = std::exchange(delay_[road], lone_wait(servers, road));
  const bool was_empty = is_empty_[road];
  is_empty_[road] = total == 0;
  if (total == 0 && was_empty && delay_[road] == before) return;  // most roads of a large net at night
  std::fill(waits.begin(), waits.end(), total == 0 ? static_cast<float>(delay_[road]) : 0.0F);
  std::fill(tolls.begin(), tolls.end(), 0.0F);
  std::fill(arrivals.begin(), arrivals.end(), 0.0F);
  for (const LaneId lane : own.lanes()) {
    if (passed[lane].empty()) continue;
    const Servers::LaneMeans& means = servers.means(lane);
    tabulate_lane(means.headway * discharge.factor(lane), means.delay, passed[lane]);
    const float weight = static_cast<float>(passed[lane].size()) / static_cast<float>(total);
    for (std::size_t b = 0; b < bins_; ++b) waits[b] += weight * lane_.wait[b];
    for (std::size_t b = 0; b < tolls.size(); ++b) tolls[b] += weight * lane_.toll[b];
    for (const Passed& one : passed[lane]) {
      const auto b =
          static_cast<std::size_t>(std::max(0.0F, one.arrived) / static_cast<float>(to_seconds(bin_)));
      if (b < bins_) arrivals[b] += 1;
    }
  }
}

void QueueTable::tabulate_lane(double headway, double delay, std::span<const Passed> passed) {
  const double bin = to_seconds(bin_);
  const double horizon = bin * static_cast<double>(bins_);
  if (!toll_.empty()) count_waiting(headway, delay, passed);
  std::size_t next = 0;
  double last_left = -1e9;
  for (std::size_t b = 0; b < bins_; ++b) {
    const double time = (static_cast<double>(b) + 0.5) * bin;
    for (; next < passed.size() && passed[next].arrived <= time; ++next) {
      const double left = static_cast<double>(passed[next].left);
      // Who is still there at the horizon leaves after the one before, and not before the horizon.
      last_left = left <= horizon ? left : std::max(last_left + headway, horizon);
    }
    double leave = time + delay;
    if (next > 0) leave = std::max(leave, last_left + headway);
    lane_.wait[b] = static_cast<float>(leave - time);
    if (toll_.empty()) continue;
    const bool holds_up =
        next < passed.size() && leave + headway > static_cast<double>(passed[next].arrived) + delay;
    lane_.toll[b] = holds_up ? static_cast<float>(headway * std::max(1.0, waiting_[next])) : 0.0F;
  }
}

void QueueTable::count_waiting(double headway, double delay, std::span<const Passed> passed) {
  waiting_.assign(passed.size() + 1, 0);
  for (std::size_t i = passed.size(); i-- > 0;) {
    const double alone = static_cast<double>(passed[i].arrived) + delay;
    if (static_cast<double>(passed[i].left) <= alone + headway / 2) continue;
    const double behind = i + 1 < passed.size() ? passed[i + 1].arrived - passed[i].arrived : 0;
    waiting_[i] = 1 + std::exp(-behind / adapting) * waiting_[i + 1];
  }
}

}  // namespace thalweg
