// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <utility>

#include "core/time.hpp"

namespace thalweg {

/// Makes what was seen count less and less: 1/e after `memory` s.
class Fading {
 public:
  explicit Fading(double memory) : memory_(memory) {}

  /// Moves on to `now`: the share that is left of what there was at the last call (at the first: at 0).
  [[nodiscard]] double advance(Millis now) {
    return std::exp(-to_seconds(now - std::exchange(last_, now)) / memory_);
  }

 private:
  double memory_;
  Millis last_ = 0;
};

}  // namespace thalweg
