// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "graph/road_graph.hpp"

namespace thalweg {

/// The travel times of one run as SUMO recorded them (edgeData with a period, internal roads included): of
/// every road by the time of entering it. Linear between the middles of the intervals, and made so that
/// leaving later never arrives earlier: who is on a road is not passed by one that enters later, so that the
/// time of an interval is at most that of the next and the way to it. A road that nobody crossed in an
/// interval takes the (lower) median of the others, one that nobody ever crossed its free flow.
class RecordedTimes {
 public:
  /// InputError: no edgeData, or its intervals are not of one length and one after the other.
  RecordedTimes(const std::filesystem::path& edge_data, const Network& network);

  [[nodiscard]] Millis leave(RoadId road, Millis entry, Millis free_flow) const {
    if (first_[road] == nobody) return entry + free_flow;
    const Millis* own = times_.data() + first_[road];
    const Millis since = entry - begin_ - interval_ / 2;
    if (since <= 0) return entry + std::max(free_flow, own[0]);
    const auto i = static_cast<std::size_t>(since / interval_);
    if (i + 1 >= count_) return entry + std::max(free_flow, own[count_ - 1]);
    const Millis within = since - static_cast<Millis>(i) * interval_;
    return entry + std::max(free_flow, own[i] + (own[i + 1] - own[i]) * within / interval_);
  }
  /// What the road takes at the quickest.
  [[nodiscard]] Millis least(RoadId road, Millis free_flow) const {
    return first_[road] == nobody ? free_flow : std::max(free_flow, least_[road]);
  }

 private:
  static constexpr std::size_t nobody = static_cast<std::size_t>(-1);
  void settle();

  Millis begin_ = 0;
  Millis interval_ = 1;
  std::size_t count_ = 0;
  IdVector<RoadId, std::size_t> first_;  ///< in times_: of the roads that somebody drove
  IdVector<RoadId, Millis> least_;
  std::vector<Millis> times_;
};

}  // namespace thalweg
