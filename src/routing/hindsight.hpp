// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "traffic/fleet.hpp"

namespace thalweg {

struct HindsightOptions {
  double memory = 1200;  ///< s after which what was seen counts 1/e
  double prior = 30;     ///< arrivals' worth of promises kept, before anything was seen
};

/// What became of the promises. Who changes its way for the best of several uncertain forecasts is
/// disappointed on average (the winner's curse: Capen, Clapp, Campbell 1971): that best is the one whose error
/// was the most favourable. Whether this is so in this city at this hour shows when vehicles arrive: those
/// that changed against those that kept their way, each by the time that was forecast for it.
class Hindsight {
 public:
  explicit Hindsight(std::size_t vehicles, const HindsightOptions& options = {});

  /// A vehicle has decided at `now`. What counts is its last change, else its first decision.
  void decided(VehicleId vehicle, Millis now, Millis predicted_arrival, bool changed);
  /// After every look at the traffic: who has arrived?
  void observe(const Fleet& fleet, Millis now);

  /// By how much longer than forecast those took that changed, beyond those that did not: a share of the time
  /// forecast; 0 where they were not disappointed.
  [[nodiscard]] double disappointment() const;

 private:
  struct Promise {
    Millis made = -1;  ///< below 0: none
    Millis arrival = 0;
    bool changed = false;
  };
  struct Account {
    double promised = 0;  ///< s
    double taken = 0;     ///< s
    double arrivals = 0;
    [[nodiscard]] double ratio(double prior) const;
  };

  HindsightOptions options_;
  IdVector<VehicleId, Promise> promises_;
  std::vector<VehicleId> open_;
  Account changed_;
  Account kept_;
  Millis last_ = 0;
};

}  // namespace thalweg
