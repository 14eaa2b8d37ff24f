// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/dice.hpp"
#include "core/time.hpp"

namespace thalweg::lab {

/// The paper's assignment arrays, `count` numbers >= 1, ascending:
/// - regular: 1, 2 .. count
/// - normal: dense in the middle, the quantiles of a normal distribution (in the middle of 1 .. 10 count,
/// standard
///   deviation a sixth of the range)
/// - dumbbell: dense at both ends, the quantiles of an arcsine distribution
/// - gaps: each gap to the next 1 .. 9, drawn from `dice`
/// The paper names the four and shows no formula: the shapes are a reading.
/// InputError when the name is none of these.
[[nodiscard]] std::vector<Millis> assignment_array(std::string_view distribution, std::size_t count,
                                                   Dice& dice);

}  // namespace thalweg::lab
