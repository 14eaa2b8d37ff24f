// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "graph/digraph.hpp"

namespace thalweg {

/// The paper's square grid: side x side vertices, numbered row by row, neighbours joined both ways: 4 side
/// (side - 1) arcs, in the order of their tails, and each tail's by the number of the head. The corners are
/// vertices 0 and side * side - 1. Ids are 32 bits wide: side <= 32'768.
[[nodiscard]] Digraph grid_graph(std::size_t side);

}  // namespace thalweg
