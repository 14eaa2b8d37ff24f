// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/dice.hpp"
#include "graph/digraph.hpp"
#include "search/accumulated.hpp"

namespace thalweg::lab {

/// The paper's object for dynamical systems: a grid whose arcs have indices from 1 .. side and whose vertices
/// have rows of weights W[t][I], dealt at random; from corner to corner.
class DynamicGrid {
 public:
  /// The side is at least 2.
  explicit DynamicGrid(std::uint64_t side);

  struct Position {
    std::uint64_t position = 0;  ///< of hybrid's weight among the different ones, from 1
    std::uint64_t distinct = 0;  ///< different weights of all fewest-arc paths
    std::int64_t hybrid = 0;
    std::int64_t optimal = 0;
  };

  struct Scratch {
    std::vector<std::int64_t> indices;
    WeightTable table;
    AccumulatedTree tree;
  };

  /// What the paper leaves open about the table.
  struct Reading {
    std::size_t row_length = 0;     ///< 0: as long as needed; beyond its end a row weighs 0, as in PHP
    std::int64_t index_factor = 1;  ///< the indices are this times 1 .. side
  };

  /// Deals `array` to the weights and the indices to the arcs, and ranks hybrid's result.
  [[nodiscard]] Position rank(const std::vector<std::int64_t>& array, Dice& dice, Scratch& scratch,
                              Reading reading) const;
  /// The same without a table: w = factor x I.
  [[nodiscard]] Position rank_linear(std::int64_t factor, Dice& dice, Scratch& scratch) const;

  /// The same with weights that are alike at every vertex and change at `steps` indices, evenly spaced.
  [[nodiscard]] Position rank_steps(const std::vector<std::int64_t>& array, std::size_t steps, Dice& dice,
                                    Scratch& scratch) const;

  /// As long as the greatest index of a fewest-arc path asks for.
  [[nodiscard]] std::size_t full_row() const { return 2 * (side_ - 1) * side_ + 1; }
  /// What one worker holds: the table, and up to all (index, weight) pairs of a region.
  [[nodiscard]] static double bytes(std::uint64_t side) {
    const auto k = static_cast<double>(side);
    return k * k * (2 * k * k + 1) * 8;
  }

 private:
  template <class F>
  [[nodiscard]] Position ranked(const F& weight, Scratch& scratch) const;
  void deal_indices(std::int64_t factor, Dice& dice, Scratch& scratch) const;

  std::uint64_t side_;
  Digraph grid_;
  Regions regions_;
  VertexId corner_;
};

}  // namespace thalweg::lab
