// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "traffic/measured.hpp"
#include "traffic/queue_table.hpp"
#include "traffic/servers.hpp"

namespace thalweg {

struct LevelOptions {
  double memory = 600;         ///< s after which what was seen counts 1/e
  double prior = 100;          ///< traversals that the model as it is counts for
  double most_deviation = 20;  ///< s: a jam that the forecast did not expect says nothing of the level
};

/// What the forecast misses everywhere: drivers who dawdle, brake and start again take longer than free flow
/// on every road, by a share of it (`pace`) and by a time for each kind of road end. Least squares over all
/// roads, weighted by their traversals, with a prior of pace 1 and no such times.
class Level {
 public:
  explicit Level(const Network& network, const LevelOptions& options = {});

  /// Once a round of `seconds`.
  void learn(const Servers& servers, const QueueTable& expected, const MeasuredTimes& measured,
             double seconds);

  [[nodiscard]] double pace() const { return pace_; }
  [[nodiscard]] double junction_pace() const { return junction_pace_; }
  /// What a road that nobody else is on takes above its free flow, in s; internal ones included.
  [[nodiscard]] double extra(const Servers& servers, RoadId road) const {
    const double free_flow = servers.free_flow(road);
    if (is_internal_[road]) return (junction_pace_ - 1) * free_flow;
    return (pace_ - 1) * free_flow + offsets_[static_cast<std::size_t>(servers.end(road))];
  }

 private:
  /// Sums over roads, each weighted by its traversals.
  struct Sums {
    double weight = 0;
    double free_flow = 0;  ///< s
    double over = 0;       ///< s measured above what was expected
    void fade(double share);
  };
  void solve();

  LevelOptions options_;
  IdVector<RoadId, bool> is_internal_;
  std::array<Sums, road_end_count> by_end_{};
  double squares_ = 0;   ///< free flow squared
  double products_ = 0;  ///< free flow x over
  Sums junctions_{};
  double pace_ = 1;
  double junction_pace_ = 1;
  std::array<double, road_end_count> offsets_{};  ///< s
};

}  // namespace thalweg
