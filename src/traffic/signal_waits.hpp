// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/id.hpp"
#include "core/time.hpp"

namespace thalweg {

/// How much longer or shorter than in the mean one waits at a signal, by the second of its cycle in which one
/// comes to the stop line and nobody is before it: who comes in green passes, who comes as it closes waits
/// for all of the red. The farther ahead that is, the less is known of the second; it counts as normally
/// distributed around the one that is foretold, and far ahead nothing is left but the mean. It is what
/// signals can tell drivers today (SPaT messages; cf. Bodenheimer, Brauer, Eckhoff, German, IEEE VNC 2014).
/// Only of programmes whose phases have fixed lengths, or are taken to (PhaseLengths).
class SignalWaits {
 public:
  explicit SignalWaits(std::size_t movements);

  /// Farther ahead only the mean wait counts: finer knowledge made nobody arrive earlier (docs/tried.md).
  static constexpr Millis known_ahead = 240'000;

  /// `until_open`: for each second of the cycle, s until the movement may go (seconds_until_open); the cycle
  /// began at `start`, and begins anew without end.
  void set(MovementId movement, std::span<const std::size_t> until_open, Millis start);
  /// Its cycles begin at other times.
  void shift(MovementId movement, Millis start) {
    if (table_of_[movement] != none) tables_[table_of_[movement]].start = start;
  }
  /// Nothing is known of it any more.
  void clear(MovementId movement) {
    if (table_of_[movement] != none) tables_[table_of_[movement]].mean = 0;
  }

  [[nodiscard]] bool knows(MovementId movement) const { return mean(movement) > 0; }
  /// s above the mean of one that comes at `time` to the stop line of a movement that is known; looked at
  /// from `ahead` s before. Who comes later never leaves earlier, as far as `ahead` is the same.
  [[nodiscard]] double deviation(MovementId movement, Millis time, double ahead) const;
  /// The most that `deviation` is below 0; 0 of a movement that is not known.
  [[nodiscard]] double mean(MovementId movement) const {
    return movement.valid() && table_of_[movement] != none ? tables_[table_of_[movement]].mean : 0;
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  static constexpr std::size_t levels = 5;  ///< standard deviations of 1, 2, 4, 8, 16 s
  struct Table {
    Millis start;
    double mean;                                       ///< s; 0: not known
    std::vector<std::array<float, levels>> deviation;  ///< s, by the second
  };

  IdVector<MovementId, std::uint32_t> table_of_;
  std::vector<Table> tables_;
  std::vector<double> level_by_second_;  ///< log2 of the standard deviation, by whole s ahead
};

}  // namespace thalweg
