// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/time.hpp"
#include "network/network.hpp"
#include "traffic/discharge.hpp"
#include "traffic/servers.hpp"
#include "traffic/toll_table.hpp"

namespace thalweg {

/// What a forecast says of the end of each road, by the time of reaching it: `bins` rows of `bin` from its
/// moment on. Of the road, the same for all its turns: with waits a turn, vehicles are lured into a free lane
/// that they must leave again.
class QueueTable {
 public:
  QueueTable(const Network& network, Millis bin, std::size_t bins, bool with_tolls = false);

  /// From all that pass the lanes, each lane's in the order of `arrived`, to a tenth of a second, and from
  /// when those went on, in s, that somebody without room on the road had held up (TollTable::add_spillback).
  void tabulate(const Servers& servers, const Discharge& discharge,
                const IdVector<LaneId, std::vector<Passed>>& passed,
                const IdVector<RoadId, std::vector<float>>& delayed);
  /// At the forecast's moment so much of the road's room is taken.
  void note_taken(RoadId road, double share) { taken_[road] = share; }

  [[nodiscard]] Millis bin() const { return bin_; }
  [[nodiscard]] std::size_t bins() const { return bins_; }
  [[nodiscard]] double horizon() const { return to_seconds(bin_) * static_cast<double>(bins_); }  ///< s
  /// s until one leaves that reaches the end in this bin; by now means the middle of the bin.
  [[nodiscard]] float wait(RoadId road, std::size_t bin) const { return wait_[at(road, bin)]; }
  /// The same for one that enters an empty road now and takes so many s to its end.
  [[nodiscard]] double wait_after(RoadId road, double seconds) const { return wait(road, bin_at(seconds)); }
  /// The one in which a time from the forecast on is, in s; the last for all later ones.
  [[nodiscard]] std::size_t bin_at(double seconds) const {
    return std::min(bins_ - 1, static_cast<std::size_t>(std::max(0.0, seconds) / to_seconds(bin_)));
  }
  /// Of that wait, s due to those who are before it.
  [[nodiscard]] double queue(RoadId road, std::size_t bin) const {
    return std::max(0.0, static_cast<double>(wait(road, bin)) - delay_[road]);
  }
  /// Vehicles that reach the end in this bin.
  [[nodiscard]] float arrivals(RoadId road, std::size_t bin) const { return arrivals_[at(road, bin)]; }
  /// s that all others arrive later because of one that reaches the end in this bin. Only of a table with
  /// tolls.
  [[nodiscard]] float toll(RoadId road, std::size_t bin) const { return tolls_->at(road, bin); }
  /// Share of the road's room that vehicles take at the forecast's moment.
  [[nodiscard]] double taken(RoadId road) const { return taken_[road]; }
  /// s between two that leave the road, by whatever lane.
  [[nodiscard]] double headway(RoadId road) const { return headway_[road]; }

 private:
  [[nodiscard]] std::size_t at(RoadId road, std::size_t bin) const { return road.value * bins_ + bin; }
  void tabulate_road(const Servers& servers, const Discharge& discharge, RoadId road,
                     const IdVector<LaneId, std::vector<Passed>>& passed, std::span<const float> delayed);
  void tabulate_lane(double headway, double delay, std::span<const Passed> passed);
  void add_spillback(RoadId road, std::span<const float> delayed);

  const Network& network_;
  Millis bin_;
  std::size_t bins_;
  std::vector<float> wait_;
  std::vector<float> arrivals_;
  std::optional<TollTable> tolls_;  ///< none: not asked for
  IdVector<RoadId, double> taken_;
  IdVector<RoadId, double> headway_;
  IdVector<RoadId, double> delay_;   ///< s that the first one waits
  IdVector<RoadId, bool> is_empty_;  ///< its rows are those of a road that nobody reached the end of
  std::vector<float> lane_wait_;     ///< scratch: of one lane
  std::vector<float> count_;         ///< scratch: in each bin
};

}  // namespace thalweg
