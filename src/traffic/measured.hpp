// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/time.hpp"
#include "graph/road_graph.hpp"

namespace thalweg {

/// How closely one looks at the vehicles, each with all that comes before it. Closer takes longer.
enum class Look : std::uint8_t { roads, lanes, positions };

/// Where a vehicle is at this moment.
struct Observation {
  RoadId road;          ///< internal ones included
  double speed = 0;     ///< m/s
  VehicleId vehicle{};  ///< invalid: the demand does not name it
  LaneId lane{};        ///< from Look::lanes on
  double position = 0;  ///< m from the beginning of the lane; with Look::positions
};

/// What was seen of a road over the window: the travel time is their quotient (Edie 1963).
struct Passage {
  double vehicle_seconds = 0;
  double traversals = 0;  ///< metres driven / length
};

/// The live travel time of every road: its length by its mean speed over the last `window`. At each sample a
/// road counts the mean speed of the vehicles on it, an empty road its limit; the samples are averaged. This
/// is how SUMO's device.rerouting measures (MSRoutingEngine, adaptation-steps 180), internal roads included.
/// Speeds are kept in whole mm/s: what was added is taken away again to the last unit.
class MeasuredTimes {
 public:
  /// `interval`: the time between two calls of `sample`.
  MeasuredTimes(const Network& network, Millis window, Millis interval);

  void sample(std::span<const Observation> vehicles);

  /// Over which passages are counted, in s.
  [[nodiscard]] double window() const { return static_cast<double>(ring_.size()) * interval_; }
  [[nodiscard]] Passage passage(RoadId road) const {
    return {.vehicle_seconds = static_cast<double>(seen_[road].count) * interval_,
            .traversals = length_[road] > 0 ? static_cast<double>(seen_[road].sum) * interval_ /
                                                  static_cast<double>(length_[road])
                                            : 0};
  }

  /// The times of now, for a class with these free-flow times: never below them.
  void live(const RoadTimes& free_flow, RoadTimes& out) const;

 private:
  struct Speeds {
    std::int64_t sum = 0;  ///< mm/s
    std::int32_t count = 0;
  };
  struct Entry {
    RoadId road;
    std::int32_t deviation = 0;  ///< mm/s: mean speed of the vehicles, less the limit
    Speeds speeds{};
  };

  IdVector<RoadId, std::int32_t> limit_;      ///< mm/s
  IdVector<RoadId, std::int64_t> length_;     ///< mm
  IdVector<RoadId, std::int64_t> deviation_;  ///< mm/s, summed over the window
  IdVector<RoadId, Speeds> seen_;             ///< summed over the window
  double interval_;                           ///< s
  std::vector<std::vector<Entry>> ring_;      ///< a slot a sample
  std::size_t slot_ = 0;
  IdVector<RoadId, Speeds> speeds_;  ///< of the sample at hand; all zero in between
};

}  // namespace thalweg
