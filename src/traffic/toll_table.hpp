// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/id.hpp"
#include "core/time.hpp"

namespace thalweg {

/// One that queued at the end of a lane, in s from the forecast on.
struct Passed {
  float arrived;
  float left;               ///< infinity: still there at the horizon
  std::uint32_t mover = 0;  ///< who, by the forecast's numbers; nothing to the tables, as what follows
  MovementId movement{};    ///< which it wants
};

/// What a forecast says of one lane's end.
struct LaneQueue {
  double headway;                   ///< s between two that leave it
  double delay;                     ///< s that one waits there when nobody is before it
  std::span<const Passed> passed;   ///< in the order of `arrived`
  std::span<const float> arrivals;  ///< vehicles of these in each bin
  std::span<const float> wait;      ///< s, of one that comes in the middle of each bin
};

/// What one more vehicle at the end of a road costs all others, by the time of reaching it, in s that they
/// arrive later, taken together: the difference between Wardrop's equilibrium and the least for all (Pigou
/// 1920; Merchant, Nemhauser 1978). Of a lane, the larger of two:
/// - a queue: one headway for each that waits behind it, until the queue has once been served. Who comes
///   300 s later counts 1/e: it can still choose another way;
/// - without a queue as well, since vehicles come at random: half of x d'(x), d the time-dependent overflow
///   delay at the degree of saturation x (Kimber, Hollis 1979; Akçelik 1980).
/// And of a full road, those who do not want to get on it at all, but wait behind somebody who does (cf.
/// Qian, Shen, Zhang, Transportation Research Part B 2012). Towards the forecast's horizon all of it fades:
/// who comes after that is not known.
class TollTable {
 public:
  TollTable(std::size_t roads, Millis bin, std::size_t bins);

  [[nodiscard]] float at(RoadId road, std::size_t bin) const { return toll_[road.value * bins_ + bin]; }

  void clear(RoadId road);
  /// A lane that has `weight` of the road's vehicles.
  void add(RoadId road, float weight, const LaneQueue& lane);
  /// `headway`: s between two that leave the road; `delayed`: how many went on in each bin who had waited
  /// behind somebody that had no room on this road.
  void add_spillback(RoadId road, double headway, std::span<const float> delayed);

 private:
  void count_waiting(const LaneQueue& lane);
  void sum_arrivals(const LaneQueue& lane);
  [[nodiscard]] double of_queue(const LaneQueue& lane, std::size_t next, double leaves) const;
  /// overflow_, from what reaches the lane's end within the period around each bin.
  void find_overflow(const LaneQueue& lane);

  double bin_;  ///< s
  std::size_t bins_;
  std::vector<float> toll_;
  std::vector<double> waiting_;   ///< scratch: from each on, how many in a row wait for the one before
  std::vector<double> arrivals_;  ///< scratch: before each bin
  std::vector<double> overflow_;  ///< scratch: vehicles a second, then s, by bin
};

}  // namespace thalweg
