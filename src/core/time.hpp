// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace thalweg {

/// Milliseconds. A cost, a duration and a moment of the simulation are all counted in them: sums are exact,
/// so two algorithms that find the same path find the same number. Doubles live at SUMO's door only.
using Millis = std::int64_t;

/// No path, never. Half of the range, so that infinity + a cost does not overflow.
inline constexpr Millis infinity = std::numeric_limits<Millis>::max() / 2;

/// a + b for costs >= 0; whatever reaches infinity stays there.
constexpr Millis add_saturating(Millis a, Millis b) { return a >= infinity - b ? infinity : a + b; }

/// Rounded to the nearest millisecond; what is not finite or too large becomes infinity.
constexpr Millis from_seconds(double seconds) {
  const double ms = seconds * 1000.0;
  if (!(ms < static_cast<double>(infinity))) return infinity;
  if (ms < -static_cast<double>(infinity)) return -infinity;
  const auto whole = static_cast<Millis>(ms);  // std::round is a call where the processor's is not asked for
  const double rest = ms - static_cast<double>(whole);
  return whole + (rest >= 0.5 ? 1 : 0) - (rest <= -0.5 ? 1 : 0);
}
constexpr double to_seconds(Millis t) { return static_cast<double>(t) / 1000.0; }

/// SUMO's time formats: seconds ("12.5", "-1") or [d:]h:m:s ("15:00:00", "1:0:0:0"). nullopt: not a time.
std::optional<Millis> parse_time(std::string_view text);

/// Seconds with two decimals, as SUMO writes them ("12.50").
std::string format_seconds(Millis t);

}  // namespace thalweg
