// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/time.hpp"
#include "graph/road_graph.hpp"

namespace thalweg {

/// Where a vehicle is at this moment: a road, internal ones included, and its speed in m/s.
struct Observation {
  RoadId road;
  double speed = 0;
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

  /// The times of now, for a class with these free-flow times: never below them.
  void live(const RoadTimes& free_flow, RoadTimes& out) const;

 private:
  struct Entry {
    RoadId road;
    std::int32_t deviation;  ///< mm/s: mean speed of the vehicles, less the limit
  };
  struct Speeds {
    std::int64_t sum = 0;  ///< mm/s
    std::int32_t count = 0;
  };

  IdVector<RoadId, std::int32_t> limit_;      ///< mm/s
  IdVector<RoadId, std::int64_t> length_;     ///< mm
  IdVector<RoadId, std::int64_t> deviation_;  ///< mm/s, summed over the window
  std::vector<std::vector<Entry>> ring_;      ///< a slot a sample
  std::size_t slot_ = 0;
  IdVector<RoadId, Speeds> speeds_;  ///< of the sample at hand; all zero in between
};

}  // namespace thalweg
