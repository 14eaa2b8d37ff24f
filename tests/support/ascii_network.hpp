// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <cctype>
#include <initializer_list>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/number.hpp"
#include "graph/road_graph.hpp"
#include "network/network.hpp"
#include "network/read_network.hpp"

namespace thalweg::testing {

/// What differs from the drawing on one road.
struct RoadOptions {
  std::optional<double> length{};  ///< m
  std::optional<double> speed{};   ///< m/s
  std::string permissions{};       ///< attributes of its lane: `allow="bus"`, `disallow="passenger"`
  std::string type{};
};

struct AsciiOptions {
  double metres = 100;            ///< a character between two junctions
  double speed = 10;              ///< m/s, on roads and junctions
  double junction_metres = 0;     ///< length of the internal lane of each turn; 0: a net without them
  bool turn_arounds = false;      ///< whether AB leads to BA
  std::string forbidden_turns{};  ///< by their junctions: "ABC ABD" keeps AB from leading to BC and BD
  std::map<std::string, RoadOptions> roads{};
};

namespace detail {

struct DrawnRoad {
  char from;
  char to;
  std::size_t characters;
  [[nodiscard]] std::string id() const { return {from, to}; }
};

inline std::vector<std::string_view> lines_of(std::string_view map) {
  std::vector<std::string_view> lines;
  while (!map.empty()) {
    const auto end = map.find('\n');
    lines.push_back(map.substr(0, end));
    map.remove_prefix(end == std::string_view::npos ? map.size() : end + 1);
  }
  return lines;
}

inline bool is_junction(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }

/// Follows the line that starts beside a junction to the right (or down) and adds its roads.
template <class At>
void draw_road(const At& at, std::size_t row, std::size_t column, bool down, std::vector<DrawnRoad>& roads) {
  const char stroke = down ? '|' : '-';
  const char there = down ? 'v' : '>';
  const char back = down ? '^' : '<';
  std::size_t characters = 0;
  bool is_there = true;
  bool is_back = true;
  char c = at(row + (down ? 1 : 0), column + (down ? 0 : 1));
  for (; c == stroke || c == there || c == back; ++characters) {
    is_there = is_there && c != back;
    is_back = is_back && c != there;
    const std::size_t step = characters + 2;
    c = at(row + (down ? step : 0), column + (down ? 0 : step));
  }
  if (characters == 0) return;
  if (!is_junction(c)) throw std::invalid_argument("a line of the map ends in no junction");
  const char start = at(row, column);
  if (is_there) roads.push_back({.from = start, .to = c, .characters = characters});
  if (is_back) roads.push_back({.from = c, .to = start, .characters = characters});
}

inline std::vector<DrawnRoad> drawn_roads(std::string_view map, std::map<char, Point>& junctions) {
  const auto lines = lines_of(map);
  const auto at = [&](std::size_t row, std::size_t column) {
    return row < lines.size() && column < lines[row].size() ? lines[row][column] : ' ';
  };
  std::vector<DrawnRoad> roads;
  for (std::size_t row = 0; row < lines.size(); ++row) {
    for (std::size_t column = 0; column < lines[row].size(); ++column) {
      if (!is_junction(at(row, column))) continue;
      const Point place{.x = static_cast<double>(column), .y = -static_cast<double>(row)};
      if (!junctions.emplace(at(row, column), place).second)
        throw std::invalid_argument("the map has a junction twice");
      draw_road(at, row, column, false, roads);
      draw_road(at, row, column, true, roads);
    }
  }
  return roads;
}

}  // namespace detail

/// The .net.xml of a drawing:
///
///     A--B->C
///     |     |
///     D-----E
///
/// Capital letters are junctions, '-' and '|' are roads both ways, '>', '<', '^' and 'v' within such a line
/// make it one way. The road from A to B is called AB, and is 100 m long for each character between the two
/// (AB: 200 m). Every road leads to every other that starts where it ends, but for turn-arounds.
inline std::string ascii_net_xml(std::string_view map, const AsciiOptions& options = {}) {
  std::map<char, Point> junctions;
  const auto roads = detail::drawn_roads(map, junctions);
  std::string edges;
  std::string internal;
  std::string connections;
  for (const auto& road : roads) {
    const auto found = options.roads.find(road.id());
    const RoadOptions own = found == options.roads.end() ? RoadOptions{} : found->second;
    edges += fmt::format(
        "<edge id=\"{0}\" from=\"{1}\" to=\"{2}\" type=\"{3}\">"
        "<lane id=\"{0}_0\" index=\"0\" length=\"{4}\" speed=\"{5}\" {6}/></edge>\n",
        road.id(), road.from, road.to, own.type,
        own.length.value_or(options.metres * static_cast<double>(road.characters)),
        own.speed.value_or(options.speed), own.permissions);
  }
  std::size_t turn = 0;
  for (const auto& from : roads) {
    for (const auto& to : roads) {
      if (from.to != to.from || (from.from == to.to && !options.turn_arounds)) continue;
      const std::string letters{from.from, from.to, to.to};
      if (options.forbidden_turns.find(letters) != std::string::npos) continue;
      const std::string via = fmt::format(":{}_{}", from.to, turn++);
      const char direction = from.from == to.to ? 't' : 's';
      const bool has_via = options.junction_metres > 0;
      if (has_via) {
        internal += fmt::format(
            "<edge id=\"{0}\" function=\"internal\">"
            "<lane id=\"{0}_0\" index=\"0\" length=\"{1}\" speed=\"{2}\"/></edge>\n",
            via, options.junction_metres, options.speed);
      }
      connections += fmt::format(
          "<connection from=\"{}\" to=\"{}\" fromLane=\"0\" toLane=\"0\" {} dir=\"{}\" state=\"M\"/>\n",
          from.id(), to.id(), has_via ? fmt::format("via=\"{}_0\"", via) : "", direction);
    }
  }
  std::string nodes;
  for (const auto& [name, place] : junctions) {
    nodes += fmt::format("<junction id=\"{}\" type=\"priority\" x=\"{}\" y=\"{}\"/>\n", name,
                         place.x * options.metres, place.y * options.metres);
  }
  return "<net>\n" + internal + edges + nodes + connections + "</net>\n";
}

inline Network ascii_network(std::string_view map, const AsciiOptions& options = {}) {
  return parse_network(ascii_net_xml(map, options));
}

inline RoadId road(const Network& network, std::string_view id) {
  const auto found = network.find_road(id);
  if (!found) throw std::invalid_argument(fmt::format("the network has no road '{}'", id));
  return *found;
}

/// The roads of a way: "ABCD" is AB, BC, CD.
inline std::vector<RoadId> way(const Network& network, std::string_view junctions) {
  std::vector<RoadId> roads;
  for (std::size_t i = 0; i + 1 < junctions.size(); ++i)
    roads.push_back(road(network, junctions.substr(i, 2)));
  return roads;
}

/// The names of the roads, for messages that can be read: "AB BC CD".
inline std::string names(const Network& network, const std::vector<RoadId>& roads) {
  std::string text;
  for (const RoadId road : roads) text += (text.empty() ? "" : " ") + network.roads[road].id;
  return text;
}

inline VertexId vertex(const Network& network, const RoadGraph& graph, std::string_view id) {
  return graph.vertex(road(network, id));
}

/// `way` as vertices of the graph.
inline std::vector<VertexId> vertex_way(const Network& network, const RoadGraph& graph,
                                        std::string_view junctions) {
  const std::vector<RoadId> roads = way(network, junctions);
  std::vector<VertexId> vertices(roads.size());
  for (std::size_t i = 0; i < roads.size(); ++i) vertices[i] = graph.vertex(roads[i]);
  return vertices;
}

inline std::string names(const Network& network, const RoadGraph& graph,
                         const std::vector<VertexId>& vertices) {
  std::vector<RoadId> roads(vertices.size());
  for (std::size_t i = 0; i < roads.size(); ++i) roads[i] = graph.road(vertices[i]);
  return names(network, roads);
}

/// What a road takes at its limit, without penalties, for a class that drives at any limit.
inline RoadTimes limit_times(const Network& network) {
  return free_flow_times(network, VehicleClass::ignoring, 1000, {.minor = 0, .turnaround = 0, .signal = 0});
}

}  // namespace thalweg::testing
