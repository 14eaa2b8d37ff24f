// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "traffic/fading.hpp"
#include "traffic/until_arrival.hpp"

namespace thalweg {

struct OverrunOptions {
  double memory = 1200;  ///< s after which what was seen counts 1/e
  double prior = 100;    ///< predictions that the model as it is counts for
  /// s, and so much of what was foretold: no prediction counts for a larger error, which is one jam's and
  /// would make the others' predictions worse.
  double most = 10;
  double most_share = 0.2;
};

/// How much later than foretold vehicles arrive: a time, and a share of what was left. Who takes the best of
/// several uncertain ways is disappointed on average (the winner's curse), and what the model does not know
/// of makes everybody late. Least squares over the predictions of those who have arrived; those before a
/// change of way are moot. No part in decisions: it is the same for all ways that take as long.
class Overrun {
 public:
  explicit Overrun(std::size_t vehicles, const OverrunOptions& options = {})
      : options_(options), fading_(options.memory), open_(vehicles) {}

  /// At `now` the model foretells that it arrives at `arrival`, by a way that is new or not.
  void predicted(VehicleId vehicle, Millis now, Millis arrival, bool is_new_way);
  /// After every look at the traffic: who has arrived?
  void observe(const Fleet& fleet, Millis now);

  /// For one that is foretold to arrive in `left`: how much later it will be; not before now.
  [[nodiscard]] Millis later(Millis left) const;

 private:
  struct Prediction {
    Millis made;
    Millis arrival;
  };

  OverrunOptions options_;
  Fading fading_;
  UntilArrival<std::vector<Prediction>> open_;
  // Sums over predictions; x: s that were foretold, y: s that it took on top.
  double n_ = 0, x_ = 0, y_ = 0, xx_ = 0, xy_ = 0;
  double share_ = 0;
  double offset_ = 0;  ///< s
};

}  // namespace thalweg
