// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <deque>
#include <vector>

#include "core/time.hpp"
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
  double lead = 300;         ///< s after which a forecast is compared with what came
  double most_late = 60;     ///< s that one such comparison counts at the most
};

/// What was measured of each road, internal ones included, less what the model says of now. What lasts (a
/// signal's bad timing, a slow lane) is learned over the run and moves the whole forecast; what is left of
/// the last minutes moves it the less, the farther it looks ahead. Beside them, what the forecasts made some
/// minutes ago missed: a queue that the model lets grow or dissolve too soon is right now, where its vehicles
/// are counted, and wrong later. Such a bias by lead time is corrected as that of weather models is (Glahn,
/// Lowry 1972).
class Residuals {
 public:
  explicit Residuals(const Network& network, const ResidualOptions& options = {});

  /// Once a round of `seconds`, from the forecast made at `now`.
  void learn(const Servers& servers, const Level& level, const QueueTable& expected,
             const MeasuredTimes& measured, double seconds, Millis now);

  [[nodiscard]] double lasting(RoadId road) const { return lasting_[road]; }  ///< s
  [[nodiscard]] double passing(RoadId road) const { return passing_[road]; }  ///< s
  /// s that one takes longer than foretold who enters the road `lead` from now or later; before, a share of
  /// it. 0 on internal roads.
  [[nodiscard]] double late(RoadId road) const { return late_[road]; }
  /// Shares of these that count so many s ahead.
  [[nodiscard]] double passing_left(double ahead) const { return std::exp(-ahead / options_.fading); }
  [[nodiscard]] double late_share(double ahead) const { return std::min(1.0, ahead / options_.lead); }

 private:
  struct Sums {
    double weight = 0;  ///< traversals
    double over = 0;    ///< s above the model, weighted
    void fade(double share);
    void add(double more, double seconds);
    [[nodiscard]] double mean(double prior) const { return over / (weight + prior); }
  };
  /// What a forecast said of those who enter `lead` later.
  struct Outlook {
    Millis made;
    std::vector<float> times;  ///< s, by road; nothing of internal ones
  };

  const Network& network_;
  ResidualOptions options_;
  IdVector<RoadId, Sums> sums_;
  IdVector<RoadId, Sums> late_sums_;
  IdVector<RoadId, double> lasting_;
  IdVector<RoadId, double> passing_;
  IdVector<RoadId, double> late_;
  std::deque<Outlook> outlooks_;  ///< by time; the first is compared next, or was compared last
};

}  // namespace thalweg
