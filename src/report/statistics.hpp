// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>

namespace thalweg {

/// A mean and its 95 % interval, mean +- half_width. One value is no interval; no value is no mean (NaN).
struct Estimate {
  std::size_t count = 0;
  double mean = std::numeric_limits<double>::quiet_NaN();
  std::optional<double> half_width{};

  [[nodiscard]] std::optional<double> low() const;
  [[nodiscard]] std::optional<double> high() const;
  /// There is an interval, and 0 is not in it.
  [[nodiscard]] bool differs_from_zero() const;
};

/// The mean over seeds, with Student's t.
Estimate estimate(std::span<const double> values);

/// The mean of a[i] - b[i], with Student's t over the pairs. Both of one length.
Estimate paired_difference(std::span<const double> a, std::span<const double> b);

/// mean(a) - mean(b) as if the samples were independent: Welch's interval (Biometrika 34, 1947).
Estimate welch_difference(std::span<const double> a, std::span<const double> b);

/// Pearson's correlation of the pairs; nullopt with fewer than three, or when one side does not vary.
std::optional<double> correlation(std::span<const double> a, std::span<const double> b);

/// How many more values like these it takes until the interval's half width is at most `half_width`:
/// 0 when it is already; nullopt with fewer than two values, or when a million would not do.
std::optional<std::size_t> more_values_needed(std::span<const double> values, double half_width);

}  // namespace thalweg
