// SPDX-License-Identifier: Apache-2.0
#include "graph/grid.hpp"

#include <vector>

namespace thalweg {

Digraph grid_graph(std::size_t side) {
  std::vector<ArcEnds> arcs;
  if (side > 1) arcs.reserve(4 * side * (side - 1));
  for (std::size_t row = 0; row < side; ++row) {
    for (std::size_t column = 0; column < side; ++column) {
      const std::size_t v = row * side + column;
      const auto join = [&](std::size_t to) { arcs.push_back({.tail = VertexId{v}, .head = VertexId{to}}); };
      if (row > 0) join(v - side);
      if (column > 0) join(v - 1);
      if (column + 1 < side) join(v + 1);
      if (row + 1 < side) join(v + side);
    }
  }
  return {side * side, arcs};
}

}  // namespace thalweg
