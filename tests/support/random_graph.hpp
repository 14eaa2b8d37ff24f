// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "core/id.hpp"
#include "core/time.hpp"
#include "graph/digraph.hpp"
#include "search/instance.hpp"
#include "support/instance.hpp"

namespace thalweg::testing {

/// Seeded, and the same on every platform (the standard's distributions are not).
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  /// 0 .. sides - 1
  std::size_t roll(std::size_t sides) { return static_cast<std::size_t>(engine_() % sides); }
  template <class T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[roll(i)]);
  }

 private:
  std::mt19937_64 engine_;
};

/// Costs by turns (from the seed): few different ones with zeros (ties), a wide range, all zero, some
/// infinite.
inline std::vector<Millis> random_costs(std::size_t arcs, std::uint64_t seed) {
  Dice dice(seed);
  std::vector<Millis> costs(arcs);
  for (Millis& cost : costs) {
    switch (seed % 4) {
      case 0:
        cost = static_cast<Millis>(dice.roll(4));
        break;
      case 1:
        cost = static_cast<Millis>(dice.roll(100'000));
        break;
      case 2:
        cost = seed % 16 == 2 ? 0 : static_cast<Millis>(1 + dice.roll(9));
        break;
      default:
        cost = dice.roll(8) == 0 ? infinity : static_cast<Millis>(dice.roll(1'000));
    }
  }
  return costs;
}

/// A random instance of the given type with 1 .. 24 vertices (mixed and directed: at least 3, so that the
/// type exists). Some vertices have no arc, some cannot be reached or left; parallel arcs occur, and loops
/// where the type allows them. Vertices and arcs are numbered at random.
inline Instance random_instance(InstanceType type, std::uint64_t seed) {
  Dice dice(seed);
  const std::size_t least = type == InstanceType::simple ? 1 : 3;
  const std::size_t vertices = least + dice.roll(25 - least);
  const std::size_t active =
      std::max(least, vertices - dice.roll(vertices / 4 + 1));  // the others get no arc
  const std::size_t pairs = dice.roll(3 * active + 1);
  std::vector<VertexId> name(vertices);
  for (std::size_t i = 0; i < vertices; ++i) name[i] = VertexId{i};
  dice.shuffle(name);

  std::vector<ArcEnds> arcs;
  std::set<std::pair<std::size_t, std::size_t>> one_way;
  std::set<std::pair<std::size_t, std::size_t>> both_ways;
  const auto add = [&](std::size_t tail, std::size_t head) {
    arcs.push_back({.tail = name[tail], .head = name[head]});
  };
  const auto add_one_way = [&](std::size_t tail, std::size_t head) {
    if (tail == head || both_ways.contains({tail, head})) return;
    if (one_way.contains({head, tail})) std::swap(tail, head);
    one_way.insert({tail, head});
    add(tail, head);
  };
  const auto add_both_ways = [&](std::size_t a, std::size_t b) {
    if (one_way.contains({a, b}) || one_way.contains({b, a})) return;
    both_ways.insert({a, b});
    both_ways.insert({b, a});
    add(a, b);
    if (a != b) add(b, a);
  };
  if (type != InstanceType::simple) add_one_way(0, 1);
  if (type == InstanceType::mixed) add_both_ways(1, 2);
  const std::size_t one_way_pairs = type == InstanceType::simple     ? 0
                                    : type == InstanceType::directed ? pairs
                                                                     : dice.roll(pairs + 1);
  for (std::size_t i = 0; i < one_way_pairs; ++i) {
    const std::size_t tail = dice.roll(active);
    add_one_way(tail, dice.roll(active));
  }
  for (std::size_t i = one_way_pairs; i < pairs; ++i) {
    const std::size_t a = dice.roll(active);
    add_both_ways(a, dice.roll(active));
  }
  dice.shuffle(arcs);
  return {.graph = Digraph(vertices, arcs), .costs = random_costs(arcs.size(), seed)};
}

/// The paper's simple grid of side x side vertices, row by row, 4 side (side - 1) arcs; costs 1 .. max_cost.
inline Instance random_grid(std::size_t side, std::uint64_t seed, std::size_t max_cost) {
  std::vector<ArcEnds> arcs;
  const auto join = [&](std::size_t a, std::size_t b) {
    arcs.push_back({.tail = VertexId{a}, .head = VertexId{b}});
    arcs.push_back({.tail = VertexId{b}, .head = VertexId{a}});
  };
  for (std::size_t row = 0; row < side; ++row) {
    for (std::size_t column = 0; column < side; ++column) {
      const std::size_t v = row * side + column;
      if (column + 1 < side) join(v, v + 1);
      if (row + 1 < side) join(v, v + side);
    }
  }
  Dice dice(seed);
  std::vector<Millis> costs(arcs.size());
  for (Millis& cost : costs) cost = static_cast<Millis>(1 + dice.roll(max_cost));
  return {.graph = Digraph(side * side, arcs), .costs = std::move(costs)};
}

/// The least costs between `root` and every vertex by nothing but their definition: every arc is tried until
/// none lowers a label. Shares no code with the searches that it judges.
inline std::vector<Millis> least_costs(const Instance& instance, VertexId root, Direction direction) {
  std::vector<Millis> least(instance.graph.vertex_count(), infinity);
  least[root.value] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < instance.costs.size(); ++i) {
      const auto [tail, head] = instance.graph.ends(ArcId{i});
      const VertexId near = direction == Direction::forward ? tail : head;
      const VertexId far = direction == Direction::forward ? head : tail;
      if (least[near.value] >= infinity || instance.costs[i] >= infinity) continue;
      if (least[near.value] + instance.costs[i] >= least[far.value]) continue;
      least[far.value] = least[near.value] + instance.costs[i];
      changed = true;
    }
  }
  return least;
}

}  // namespace thalweg::testing
