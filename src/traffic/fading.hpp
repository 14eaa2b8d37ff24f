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

  /// The share that is left of what there was at the last call, the first of which counts from 0.
  [[nodiscard]] double until(Millis now) {
    return std::exp(-to_seconds(now - std::exchange(last_, now)) / memory_);
  }

 private:
  double memory_;
  Millis last_ = 0;
};

}  // namespace thalweg
