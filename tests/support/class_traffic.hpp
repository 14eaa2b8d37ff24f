// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <utility>

#include "graph/road_graph.hpp"
#include "routing/strategy.hpp"
#include "support/ascii_network.hpp"
#include "support/random_graph.hpp"

namespace thalweg::testing {

/// A network with the traffic that one class sees on it.
class SeenTraffic {
 public:
  explicit SeenTraffic(Network net, VehicleClass vehicle_class = VehicleClass::passenger)
      : network(std::move(net)), graph_(network, vehicle_class) {
    traffic.graph = &graph_;
    traffic.free_flow =
        free_flow_times(network, vehicle_class, 1000, {.minor = 0, .turnaround = 0, .signal = 0});
    traffic.road_times = traffic.free_flow;
    refresh();
  }
  SeenTraffic(const SeenTraffic&) = delete;
  SeenTraffic& operator=(const SeenTraffic&) = delete;

  [[nodiscard]] const RoadGraph& graph() const { return graph_; }
  [[nodiscard]] std::vector<VertexId> route(std::string_view junctions) const {
    return vertex_way(network, graph_, junctions);
  }
  [[nodiscard]] VertexId at(std::string_view road) const { return vertex(network, graph_, road); }
  [[nodiscard]] std::string text(const std::vector<VertexId>& route) const {
    return names(network, graph_, route);
  }
  void set_time(std::string_view id, Millis time) {
    traffic.road_times[road(network, id)] = time;
    refresh();
  }
  /// Brings the costs of the turns up to the times of the roads.
  void refresh() { turn_costs(graph_, traffic.road_times, traffic.turn_costs); }

  Network network;

 private:
  RoadGraph graph_;

 public:
  ClassTraffic traffic;
};

/// A city at random: up to 26 junctions; roads one way or both ways, parallel ones among them, with one or
/// two lanes, some for buses only; internal roads, by which parallel turns differ; some turns are missing.
inline Network random_network(std::uint64_t seed) {
  Dice dice(seed);
  const std::size_t junctions = 2 + dice.roll(25);
  std::string edges;
  std::string internal;
  std::string connections;
  struct Road {
    std::string id;
    std::size_t from;
    std::size_t to;
    std::size_t lanes;
  };
  std::vector<Road> roads;
  const auto add_road = [&](std::size_t from, std::size_t to) {
    const Road road{
        .id = fmt::format("r{}", roads.size()), .from = from, .to = to, .lanes = 1 + dice.roll(2)};
    edges += fmt::format("<edge id=\"{}\" from=\"j{}\" to=\"j{}\">", road.id, from, to);
    const bool is_bus_road = dice.roll(12) == 0;
    for (std::size_t lane = 0; lane < road.lanes; ++lane) {
      edges +=
          fmt::format("<lane id=\"{}_{}\" length=\"{}\" speed=\"{}\"{}/>", road.id, lane,
                      10 * (1 + dice.roll(30)), 5 * (1 + dice.roll(3)), is_bus_road ? " allow=\"bus\"" : "");
    }
    edges += "</edge>\n";
    roads.push_back(road);
  };
  const std::size_t pairs = junctions + dice.roll(2 * junctions);
  for (std::size_t i = 0; i < pairs; ++i) {
    const std::size_t from = dice.roll(junctions);
    const std::size_t to = dice.roll(junctions);
    if (from == to) continue;
    add_road(from, to);
    if (dice.roll(3) != 0) add_road(to, from);
  }
  std::size_t turns = 0;
  for (const Road& from : roads) {
    for (const Road& to : roads) {
      if (from.to != to.from || dice.roll(6) == 0) continue;
      for (std::size_t lane = 0; lane < std::min(from.lanes, to.lanes); ++lane) {
        const std::string via = fmt::format(":t{}", turns++);
        internal += fmt::format(
            "<edge id=\"{0}\" function=\"internal\"><lane id=\"{0}_0\" length=\"{1}\" speed=\"5\"/></edge>\n",
            via, 5 * dice.roll(8));
        connections +=
            fmt::format("<connection from=\"{}\" to=\"{}\" fromLane=\"{}\" toLane=\"{}\" via=\"{}_0\"/>\n",
                        from.id, to.id, lane, lane, via);
      }
    }
  }
  std::string nodes;
  for (std::size_t i = 0; i < junctions; ++i)
    nodes += fmt::format("<junction id=\"j{}\" x=\"0\" y=\"0\"/>\n", i);
  return parse_network("<net>\n" + internal + edges + nodes + connections + "</net>");
}

}  // namespace thalweg::testing
