// SPDX-License-Identifier: Apache-2.0
#include "traffic/queue_table.hpp"

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
      taken_(network.roads.size(), 0),
      headway_(network.roads.size(), 0),
      delay_(network.roads.size(), 0),
      is_empty_(network.roads.size(), true),
      lane_wait_(bins),
      count_(bins) {
  if (with_tolls) tolls_.emplace(network.roads.size(), bin, bins);
}

void QueueTable::tabulate(const Servers& servers, const Discharge& discharge,
                          const IdVector<LaneId, std::vector<Passed>>& passed,
                          const IdVector<RoadId, std::vector<float>>& delayed) {
  for (std::size_t i = 0; i < network_.roads.size(); ++i) {
    if (network_.roads[RoadId{i}].function == RoadFunction::normal)
      tabulate_road(servers, discharge, RoadId{i}, passed, delayed[RoadId{i}]);
  }
}

void QueueTable::tabulate_road(const Servers& servers, const Discharge& discharge, RoadId road,
                               const IdVector<LaneId, std::vector<Passed>>& passed,
                               std::span<const float> delayed) {
  const std::span<float> waits(wait_.data() + at(road, 0), bins_);
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
  is_empty_[road] = total == 0 && delayed.empty();
  if (is_empty_[road] && was_empty && delay_[road] == before) return;  // most roads of a large net at night
  std::fill(waits.begin(), waits.end(), total == 0 ? static_cast<float>(delay_[road]) : 0.0F);
  std::fill(arrivals.begin(), arrivals.end(), 0.0F);
  if (tolls_) tolls_->clear(road);
  for (const LaneId lane : own.lanes()) {
    if (passed[lane].empty()) continue;
    const Servers::LaneMeans& means = servers.means(lane);
    const double headway = means.headway * discharge.factor(lane);
    tabulate_lane(headway, means.delay, passed[lane]);
    const float weight = static_cast<float>(passed[lane].size()) / static_cast<float>(total);
    for (std::size_t b = 0; b < bins_; ++b) {
      waits[b] += weight * lane_wait_[b];
      arrivals[b] += count_[b];
    }
    if (tolls_)
      tolls_->add(road, weight,
                  {.headway = headway,
                   .delay = means.delay,
                   .passed = passed[lane],
                   .arrivals = count_,
                   .wait = lane_wait_});
  }
  if (tolls_ && !delayed.empty()) add_spillback(road, delayed);
}

void QueueTable::add_spillback(RoadId road, std::span<const float> delayed) {
  std::fill(count_.begin(), count_.end(), 0.0F);
  for (const float time : delayed) count_[bin_at(static_cast<double>(time))] += 1;
  tolls_->add_spillback(road, headway_[road], count_);
}

void QueueTable::tabulate_lane(double headway, double delay, std::span<const Passed> passed) {
  const double bin = to_seconds(bin_);
  std::fill(count_.begin(), count_.end(), 0.0F);
  for (const Passed& one : passed) count_[bin_at(static_cast<double>(one.arrived))] += 1;
  std::size_t next = 0;
  double last_left = -1e9;
  for (std::size_t b = 0; b < bins_; ++b) {
    const double time = (static_cast<double>(b) + 0.5) * bin;
    for (; next < passed.size() && passed[next].arrived <= time; ++next) {
      const double left = static_cast<double>(passed[next].left);
      // Who is still there at the horizon leaves after the one before, and not before the horizon.
      last_left = left <= horizon() ? left : std::max(last_left + headway, horizon());
    }
    double leave = time + delay;
    if (next > 0) leave = std::max(leave, last_left + headway);
    lane_wait_[b] = static_cast<float>(leave - time);
  }
}

}  // namespace thalweg
