// SPDX-License-Identifier: Apache-2.0
#include "lab/weights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "core/error.hpp"
#include "core/nearest.hpp"

namespace thalweg::lab {
namespace {

/// On the same scale for all shapes: numbers 1 .. scale x count keep the shape's gaps from rounding away.
constexpr double scale = 10;

}  // namespace

std::vector<Millis> assignment_array(std::string_view distribution, std::size_t count, Dice& dice) {
  std::vector<Millis> out(count);
  const auto place = [&](auto quantile) {
    for (std::size_t i = 0; i < count; ++i) {
      const double p = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
      const double at = std::clamp(quantile(p), 0.0, 1.0);
      out[i] = static_cast<Millis>(std::llround(1 + at * (scale * static_cast<double>(count) - 1)));
    }
  };
  if (distribution == "regular") {
    for (std::size_t i = 0; i < count; ++i) out[i] = static_cast<Millis>(i + 1);
  } else if (distribution == "normal") {
    const boost::math::normal normal(0.5, 1.0 / 6);
    place([&](double p) { return boost::math::quantile(normal, p); });
  } else if (distribution == "dumbbell") {
    place([](double p) { return std::pow(std::sin(std::numbers::pi / 2 * p), 2); });
  } else if (distribution == "gaps") {
    Millis value = 0;
    for (Millis& weight : out) weight = value += static_cast<Millis>(1 + dice.roll(9));
  } else {
    const std::array<std::string, 4> names{"regular", "normal", "dumbbell", "gaps"};
    throw InputError(fmt::format("there is no distribution '{}'{}: regular, normal, dumbbell or gaps",
                                 distribution, did_you_mean(distribution, names)));
  }
  return out;
}

}  // namespace thalweg::lab
