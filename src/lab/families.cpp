// SPDX-License-Identifier: Apache-2.0
#include "lab/families.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/nearest.hpp"
#include "graph/grid.hpp"

namespace thalweg::lab {
namespace {

constexpr Millis dear = 1'000'000'000;

CostedGraph chain(std::size_t vertices) {
  std::vector<ArcEnds> ends;
  std::vector<Millis> costs;
  for (std::size_t v = 1; v < vertices; ++v) {
    ends.push_back({.tail = VertexId{0U}, .head = VertexId{v}});
    costs.push_back(v == 1 ? 1 : dear);
    if (v + 1 == vertices) break;
    ends.push_back({.tail = VertexId{v}, .head = VertexId{v + 1}});
    costs.push_back(1);
  }
  return {.graph = Digraph(vertices, ends), .costs = std::move(costs)};
}

}  // namespace

CostedGraph make_family(std::string_view family, std::size_t vertices, Dice& dice) {
  if (family == "chain") return chain(vertices);
  CostedGraph out;
  if (family == "grid") {
    out.graph = grid_graph(static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(vertices)))));
  } else if (family == "random") {
    std::vector<ArcEnds> ends;
    for (std::size_t v = 0; v < vertices; ++v) {
      for (int i = 0; i < 3; ++i)
        ends.push_back({.tail = VertexId{v}, .head = VertexId{dice.roll(vertices)}});
    }
    out.graph = Digraph(vertices, ends);
  } else {
    const std::array<std::string, 3> names{"grid", "random", "chain"};
    throw InputError(
        fmt::format("there is no family '{}'{}: grid, random or chain", family, did_you_mean(family, names)));
  }
  out.costs.resize(out.graph.arc_count());
  for (Millis& cost : out.costs) cost = static_cast<Millis>(1 + dice.roll(100));
  return out;
}

}  // namespace thalweg::lab
