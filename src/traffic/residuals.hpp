// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "network/network.hpp"
#include "traffic/level.hpp"
#include "traffic/measured.hpp"
#include "traffic/queue_table.hpp"
#include "traffic/servers.hpp"

namespace thalweg {

struct ResidualOptions {
  double prior = 8;               ///< traversals that the model is worth against the measurement
  double longest_road = 1800;     ///< s; what is measured above it counts as this
  double longest_junction = 600;  ///< s
  double least_traversals = 0.5;
  double fading = 900;       ///< s after which a passing residual counts 1/e
  double memory = 1800;      ///< s after which what was seen counts 1/e for a lasting one
  double most_lasting = 20;  ///< s: what is more than that is a jam, and passes
};

/// What was measured of each road, internal ones included, less what the model says of now. What lasts (a
/// signal's bad timing, a slow lane) is learned over the run and moves the whole forecast; what is left of
/// the last minutes moves it the less, the farther it looks ahead.
class Residuals {
 public:
  explicit Residuals(const Network& network, const ResidualOptions& options = {});

  /// Once a round of `seconds`.
  void learn(const Servers& servers, const Level& level, const QueueTable& expected,
             const MeasuredTimes& measured, double seconds);

  [[nodiscard]] double lasting(RoadId road) const { return lasting_[road]; }  ///< s
  [[nodiscard]] double passing(RoadId road) const { return passing_[road]; }  ///< s
  [[nodiscard]] const ResidualOptions& options() const { return options_; }

 private:
  struct Sums {
    double weight = 0;  ///< traversals
    double over = 0;    ///< s above the model, weighted
  };
  const Network& network_;
  ResidualOptions options_;
  IdVector<RoadId, Sums> sums_;
  IdVector<RoadId, double> lasting_;
  IdVector<RoadId, double> passing_;
};

}  // namespace thalweg
