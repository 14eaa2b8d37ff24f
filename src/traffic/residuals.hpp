// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "network/network.hpp"
#include "traffic/measured.hpp"
#include "traffic/queue_forecast.hpp"
#include "traffic/servers.hpp"

namespace thalweg {

struct ResidualOptions {
  double prior = 8;               ///< traversals that the model is worth against the measurement
  double longest_road = 1800;     ///< s; what is measured above it counts as this
  double longest_junction = 600;  ///< s
  double least_traversals = 0.5;
  double fading = 900;  ///< s after which a residual counts 1/e
};

/// What was measured of each road, internal ones included, less what the model says of now: the forecast is
/// moved by it, the less the farther it looks ahead.
class Residuals {
 public:
  explicit Residuals(const Network& network, const ResidualOptions& options = {});

  void refresh(const Servers& servers, const QueueForecast& forecast, const MeasuredTimes& measured);

  [[nodiscard]] double operator[](RoadId road) const { return residual_[road]; }  ///< s
  [[nodiscard]] const ResidualOptions& options() const { return options_; }

 private:
  const Network& network_;
  ResidualOptions options_;
  IdVector<RoadId, double> residual_;
};

}  // namespace thalweg
