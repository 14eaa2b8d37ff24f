// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "network/network.hpp"

namespace thalweg {

/// How long the phases of a signal last that follows the traffic: means of what was seen, the last ones
/// counting most. With them it is as a programme of fixed phases whose cycle is set anew at every look.
class PhaseLengths {
 public:
  explicit PhaseLengths(SignalProgramme programme);

  /// At a look at `now`. Phases that began and ended since the last look are taken to have lasted for their
  /// means; where that cannot be, as with phases that are left out, nothing is learned.
  void see(const ShownPhase& shown, Millis now);
  /// True when the means are others by now than those of `programme`, which takes them then.
  bool take_means(Millis now);
  /// Phases of whole seconds. Its cycle began so that the phase that shows is where it should be; one that
  /// has lasted for its mean and still shows is about to end.
  [[nodiscard]] const SignalProgramme& programme() const { return programme_; }

 private:
  [[nodiscard]] std::size_t count() const { return means_.size(); }
  void learn(const ShownPhase& shown);
  void place_cycle(Millis now);

  SignalProgramme programme_;
  std::vector<double> means_;  ///< s, by phase
  std::optional<ShownPhase> last_{};
};

}  // namespace thalweg
