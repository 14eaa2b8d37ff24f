// SPDX-License-Identifier: Apache-2.0
#include "lab/dynamic_grid.hpp"

#include <algorithm>

#include "graph/grid.hpp"

namespace thalweg::lab {

DynamicGrid::DynamicGrid(std::uint64_t side)
    : side_(side), grid_(grid_graph(side)), corner_(side * side - 1) {
  const VertexId origin{0U};
  partition<Direction::forward>(grid_, {&origin, 1}, regions_);
}

template <class F>
DynamicGrid::Position DynamicGrid::ranked(const F& weight, Scratch& scratch) const {
  const auto index = [&](ArcId arc) { return scratch.indices[arc.value]; };
  hybrid_accumulated(grid_, regions_, index, weight, scratch.tree);
  const auto all = distinct_weights(grid_, regions_, corner_, index, weight);
  const std::int64_t hybrid = scratch.tree.label[corner_].weight;
  const auto at = std::lower_bound(all.begin(), all.end(), hybrid);
  return {.position = static_cast<std::uint64_t>(at - all.begin()) + 1,
          .distinct = all.size(),
          .hybrid = hybrid,
          .optimal = all.front()};
}

void DynamicGrid::deal_indices(std::int64_t factor, Dice& dice, Scratch& scratch) const {
  scratch.indices.resize(grid_.arc_count());
  for (auto& index : scratch.indices) index = factor * static_cast<std::int64_t>(1 + dice.roll(side_));
}

DynamicGrid::Position DynamicGrid::rank(const std::vector<std::int64_t>& array, Dice& dice, Scratch& scratch,
                                        Reading reading) const {
  deal_indices(reading.index_factor, dice, scratch);
  const auto needed = static_cast<std::size_t>(reading.index_factor) * (full_row() - 1) + 1;
  scratch.table.row_length = reading.row_length == 0 ? needed : reading.row_length;
  scratch.table.weights.resize(side_ * side_ * scratch.table.row_length);
  for (auto& weight : scratch.table.weights) weight = dice.pick(array);
  return ranked(scratch.table, scratch);
}

DynamicGrid::Position DynamicGrid::rank_linear(std::int64_t factor, Dice& dice, Scratch& scratch) const {
  deal_indices(1, dice, scratch);
  return ranked(LinearWeight{.factor = factor}, scratch);
}

DynamicGrid::Position DynamicGrid::rank_steps(const std::vector<std::int64_t>& array, std::size_t steps,
                                              Dice& dice, Scratch& scratch) const {
  deal_indices(1, dice, scratch);
  StepWeight weight;
  for (std::size_t i = 0; i <= steps; ++i) {
    weight.from.push_back(static_cast<std::int64_t>(i * full_row() / (steps + 1)));
    weight.weights.push_back(dice.pick(array));
  }
  return ranked(weight, scratch);
}

}  // namespace thalweg::lab
