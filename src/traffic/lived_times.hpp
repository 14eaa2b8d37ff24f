// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/time.hpp"
#include "network/network.hpp"
#include "traffic/measured.hpp"

namespace thalweg {

/// What was lived on a road in one bin of the day.
struct LivedTime {
  RoadId road;              ///< internal ones included
  double seconds = 0;       ///< to cross it, in the mean
  double observations = 0;  ///< traversals: metres driven / length
};

/// Notes one day's travel times by road and time of day, as they are lived: vehicle-seconds by traversals
/// (Edie 1963), junction roads included.
class LivedTimes {
 public:
  /// `bin`: of the time of day, counted from 0.
  LivedTimes(const Network& network, Millis bin);

  /// Everybody on the roads at `now`: each stands for the time since the look before.
  void look(std::span<const Observation> vehicles, Millis now);
  /// The day is over: what was noted, by bin; roads in order. Less than half a traversal
  /// gives no time, unless somebody stood there for half of the bin: then it counts as half a one.
  [[nodiscard]] std::vector<std::vector<LivedTime>> take();

 private:
  void close_bin();

  const Network& network_;
  Millis bin_;
  std::size_t at_ = 0;  ///< the bin that is open
  Millis last_look_ = -1;
  IdVector<RoadId, Passage> open_;
  std::vector<RoadId> seen_;  ///< in the open bin
  std::vector<std::vector<LivedTime>> closed_;
};

}  // namespace thalweg
