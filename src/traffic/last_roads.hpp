// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "traffic/fading.hpp"
#include "traffic/timed_costs.hpp"
#include "traffic/until_arrival.hpp"

namespace thalweg {

struct LastRoadOptions {
  double first = 0.5;    ///< share of the delay before anything was seen
  double prior = 300;    ///< s of delay that this is worth
  double memory = 1800;  ///< s after which what was seen counts 1/e
  double most = 60;      ///< s above the delay of those who drive on: what is more is a stop
};

/// What those meet on a road who end their trip there, while others drive on: they stand behind these in the
/// queue, but wait for no green and no gap of their own. The share of the delay of those who drive on, one
/// for all such roads.
class LastRoads {
 public:
  explicit LastRoads(std::size_t vehicles, const LastRoadOptions& options = {});

  /// After every look at the traffic, before the next forecast.
  void observe(const Fleet& fleet, const Expectation& expected, Millis now);

  [[nodiscard]] double share() const;

 private:
  struct Stay {
    Millis since = 0;     ///< first seen there
    double crossing = 0;  ///< s, nobody in the way
    double delay = 0;     ///< s, of those who drive on, as it was expected then
  };

  LastRoadOptions options_;
  Fading fading_;
  UntilArrival<Stay> stays_;
  double expected_ = 0;  ///< s of delay, of those who drive on
  double taken_ = 0;     ///< s of delay, of those who ended there
};

}  // namespace thalweg
