// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/dice.hpp"
#include "core/time.hpp"
#include "graph/digraph.hpp"

namespace thalweg::lab {

struct CostedGraph {
  Digraph graph;
  std::vector<Millis> costs;
};

/// About `vertices` vertices, from 0; weights 1 .. 100 but for the chain:
/// - grid: the square grid with the nearest number
/// - random: three arcs out of each vertex to random ones
/// - chain: 0 leads everywhere, dearly; the cheap way is from each vertex to the next (the worst case)
/// InputError when the name is none of these.
[[nodiscard]] CostedGraph make_family(std::string_view family, std::size_t vertices, Dice& dice);

}  // namespace thalweg::lab
