// SPDX-License-Identifier: Apache-2.0
#include "nets.hpp"

#include <algorithm>
#include <numeric>
#include <random>

#include "graph/grid.hpp"
#include "graph/road_graph.hpp"
#include "network/read_network.hpp"
#include "search/instance.hpp"

namespace thalweg::bench {
namespace {

constexpr std::size_t border_roads = 32;

/// The vertices with the highest (or lowest) coordinates.
std::vector<std::size_t> border(const std::vector<double>& coordinate, bool high) {
  std::vector<std::size_t> vertices(coordinate.size());
  std::iota(vertices.begin(), vertices.end(), std::size_t{0});
  std::sort(vertices.begin(), vertices.end(), [&](std::size_t a, std::size_t b) {
    return high ? coordinate[a] > coordinate[b] : coordinate[a] < coordinate[b];
  });
  vertices.resize(std::min(border_roads, vertices.size()));
  return vertices;
}

/// The vertices of the largest strongly connected component: from each of them one can go to every other.
std::vector<VertexId> main_part(const Digraph& graph) {
  const Components components = strong_components(graph);
  std::vector<std::size_t> size(components.count, 0);
  for (const std::uint32_t number : components.number) ++size[number];
  const auto largest = static_cast<std::uint32_t>(std::max_element(size.begin(), size.end()) - size.begin());
  std::vector<VertexId> part;
  for (std::size_t v = 0; v < graph.vertex_count(); ++v) {
    if (components.number[VertexId{v}] == largest) part.emplace_back(v);
  }
  return part;
}

}  // namespace

Net read_net(const std::filesystem::path& file) {
  const Network network = read_network(file);
  const RoadGraph roads(network, VehicleClass::passenger);
  Net net{.name = file.stem().stem().string(), .graph = roads.turns(), .costs = {}, .x = {}, .y = {}};
  turn_costs(
      roads,
      free_flow_times(network, VehicleClass::passenger, default_max_speed(VehicleClass::passenger), {}),
      net.costs);
  for (std::size_t v = 0; v < net.graph.vertex_count(); ++v) {
    const Point& end = network.junctions[network.roads[roads.road(VertexId{v})].to].position;
    net.x.push_back(end.x);
    net.y.push_back(end.y);
  }
  return net;
}

Net glued(const Net& net, std::size_t columns, std::size_t rows) {
  const std::size_t size = net.graph.vertex_count();
  const double width =
      *std::max_element(net.x.begin(), net.x.end()) - *std::min_element(net.x.begin(), net.x.end());
  const double height =
      *std::max_element(net.y.begin(), net.y.end()) - *std::min_element(net.y.begin(), net.y.end());
  Net whole{
      .name = net.name + "*" + std::to_string(columns * rows), .graph = {}, .costs = {}, .x = {}, .y = {}};
  std::vector<ArcEnds> arcs;
  const auto add = [&](std::size_t tail, std::size_t head, Millis cost) {
    arcs.push_back({.tail = VertexId{tail}, .head = VertexId{head}});
    whole.costs.push_back(cost);
  };
  const auto join = [&](const std::vector<std::size_t>& from, std::size_t first,
                        const std::vector<std::size_t>& to, std::size_t second) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      add(first * size + from[i], second * size + to[i], 10'000);
      add(second * size + to[i], first * size + from[i], 10'000);
    }
  };
  const auto east = border(net.x, true);
  const auto west = border(net.x, false);
  const auto north = border(net.y, true);
  const auto south = border(net.y, false);
  for (std::size_t copy = 0; copy < columns * rows; ++copy) {
    for (std::size_t i = 0; i < net.costs.size(); ++i) {
      const auto [tail, head] = net.graph.ends(ArcId{i});
      add(copy * size + tail.value, copy * size + head.value, net.costs[i]);
    }
    const std::size_t column = copy % columns;
    const std::size_t row = copy / columns;
    for (std::size_t v = 0; v < size; ++v) {
      whole.x.push_back(net.x[v] + static_cast<double>(column) * width);
      whole.y.push_back(net.y[v] + static_cast<double>(row) * height);
    }
    if (copy % columns + 1 < columns) join(east, copy, west, copy + 1);
    if (copy / columns + 1 < rows) join(north, copy, south, copy + columns);
  }
  whole.graph = Digraph(columns * rows * size, arcs);
  return whole;
}

Net grid(std::size_t side) {
  Net net{.name = "grid" + std::to_string(side), .graph = grid_graph(side), .costs = {}, .x = {}, .y = {}};
  std::mt19937_64 random(1);
  for (std::size_t i = 0; i < net.graph.arc_count(); ++i) {
    net.costs.push_back(static_cast<Millis>(1'000 + random() % 9'000));
  }
  return net;
}

std::vector<Traveller> travellers(const Net& net, std::size_t count, std::size_t per_destination) {
  const std::vector<VertexId> part = main_part(net.graph);
  std::mt19937_64 random(23'423);
  std::vector<Traveller> due(count);
  VertexId destination;
  for (std::size_t i = 0; i < count; ++i) {
    if (i % per_destination == 0) destination = part[random() % part.size()];
    due[i].vehicle = VehicleId{i};
    due[i].route = {part[random() % part.size()]};
    due[i].waypoints = {destination};
  }
  return due;
}

std::vector<Millis> live_costs(const Net& net, std::uint64_t round) {
  std::mt19937_64 random(round);
  std::vector<Millis> costs = net.costs;
  for (Millis& cost : costs) {
    if (cost < infinity) cost += static_cast<Millis>(random() % static_cast<std::uint64_t>(2 * cost + 1));
  }
  return costs;
}

}  // namespace thalweg::bench
