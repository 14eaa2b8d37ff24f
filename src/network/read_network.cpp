// SPDX-License-Identifier: Apache-2.0
#include "network/read_network.hpp"

#include <fmt/format.h>

#include <set>

#include "core/number.hpp"
#include "xml/reader.hpp"

namespace thalweg {

std::optional<RoadId> Network::find_road(std::string_view id) const {
  const auto found = road_ids.find(id);
  if (found == road_ids.end()) return std::nullopt;
  return found->second;
}

namespace {

class NetworkHandler : public xml::Handler {
 public:
  void start(const xml::Element& element) override {
    const auto name = element.name();
    if (depth_++ == 0) {
      if (name != "net") throw element.error("this is no SUMO network: its root is not <net>");
      net_.left_hand = element.boolean_or("lefthand", false);
    } else if (name == "lane") {
      read_lane(element);
    } else if (name == "edge") {
      read_road(element);
    } else if (name == "connection") {
      read_connection(element);
    } else if (name == "junction") {
      read_junction(element);
    } else if (name == "tlLogic") {
      read_programme(element);
    } else if (name == "phase") {
      read_phase(element);
    } else if (name == "type") {
      type_ = element.require("id");
    } else if (name == "restriction") {
      read_restriction(element);
    } else if (name == "roundabout") {
      read_roundabout(element);
    } else if (name == "location") {
      read_location(element);
    }
  }

  void end(std::string_view name) override {
    --depth_;
    if (name == "edge") finish_road();
    if (name == "net") finish();
  }

  Network take() { return std::move(net_); }

 private:
  static RoadFunction parse_function(const xml::Element& element) {
    const auto text = element.value_or("function", "normal");
    if (text == "normal") return RoadFunction::normal;
    if (text == "connector") return RoadFunction::connector;
    if (text == "internal") return RoadFunction::internal;
    if (text == "crossing") return RoadFunction::crossing;
    if (text == "walkingarea") return RoadFunction::walking_area;
    throw element.error(fmt::format("function='{}' is unknown", text));
  }

  static double non_negative(const xml::Element& element, std::string_view attribute) {
    const double value = element.number(attribute);
    if (value < 0)
      throw element.error(fmt::format("{}='{}' is negative", attribute, element.require(attribute)));
    return value;
  }

  static Shape parse_shape(const xml::Element& element) {
    Shape shape;
    const auto text = element.find("shape");
    if (!text) return shape;
    const auto points = split(*text, " \t\r\n");
    shape.reserve(points.size());
    for (const auto point : points) {
      const auto fields = split(point, ",");
      std::optional<double> x = !fields.empty() ? parse_number(fields[0]) : std::nullopt;
      std::optional<double> y = fields.size() > 1 ? parse_number(fields[1]) : std::nullopt;
      std::optional<double> z = fields.size() > 2 ? parse_number(fields[2]) : 0.0;
      if (!x || !y || !z) throw element.error(fmt::format("shape: '{}' is not a point", point.substr(0, 80)));
      shape.push_back({.x = *x, .y = *y, .z = *z});
    }
    return shape;
  }

  /// A junction may be named, by `element`, before it is described.
  JunctionId junction(const xml::Element& element, std::string_view id) {
    const auto [entry, is_new] = junction_ids_.try_emplace(std::string(id), net_.junctions.next_id());
    if (is_new) {
      net_.junctions.push_back({.id = std::string(id), .type = {}, .position = {}, .shape = {}});
      junction_missing_.push_back(
          element.error(fmt::format("the junction '{}' is not in the net", id)).what());
    }
    return entry->second;
  }

  void read_road(const xml::Element& element) {
    Road road;
    road.id = element.require("id");
    road.function = parse_function(element);
    if (road.function == RoadFunction::normal || road.function == RoadFunction::connector) {
      road.from = junction(element, element.require("from"));
      road.to = junction(element, element.require("to"));
    }
    road.type = element.value_or("type", "");
    road.name = element.value_or("name", "");
    road.priority = element.find("priority") ? element.integer("priority") : 0;
    road.first_lane = net_.lanes.next_id();
    road.shape = parse_shape(element);
    if (!net_.road_ids.try_emplace(road.id, net_.roads.next_id()).second) {
      throw element.error("there is an edge of this id already");
    }
    road_error_ = element.error("the edge has no lanes").what();
    net_.roads.push_back(std::move(road));
    in_road_ = true;
  }

  /// Lanes count in the order of the file, as in SUMO: real nets have wrong indices.
  void read_lane(const xml::Element& element) {
    if (!in_road_) throw element.error("a lane outside of an edge");
    const RoadId road{net_.roads.size() - 1};
    Lane lane;
    lane.road = road;
    lane.length = non_negative(element, "length");
    lane.speed = non_negative(element, "speed");
    lane.permissions = permissions(element, "allow", "disallow");
    lane.change_left = permissions(element, "changeLeft", "");
    lane.change_right = permissions(element, "changeRight", "");
    lane.shape = parse_shape(element);
    if (!lane_ids_.try_emplace(std::string(element.require("id")), net_.lanes.next_id()).second) {
      throw element.error("there is a lane of this id already");
    }
    net_.lanes.push_back(std::move(lane));
    ++net_.roads[road].lane_count;
  }

  void finish_road() {
    in_road_ = false;
    const Road& road = net_.roads[RoadId{net_.roads.size() - 1}];
    if (road.lane_count == 0) throw InputError(road_error_);
  }

  Permissions permissions(const xml::Element& element, std::string_view allow, std::string_view disallow) {
    std::vector<std::string> unknown;
    const auto result = parse_permissions(element.find(allow),
                                          disallow.empty() ? std::nullopt : element.find(disallow), unknown);
    for (const auto& name : unknown) {
      if (unknown_classes_.insert(name).second) {
        net_.warnings.push_back(
            element
                .error(fmt::format("the vehicle class '{}' is unknown and left out (a newer SUMO's?)", name))
                .what());
      }
    }
    return result;
  }

  RoadId connected_road(const xml::Element& element, std::string_view attribute) const {
    const auto id = element.require(attribute);
    const auto road = net_.find_road(id);
    if (!road) throw element.error(fmt::format("{}='{}' is no edge of this net", attribute, id));
    return *road;
  }

  std::uint32_t connected_lane(const xml::Element& element, std::string_view attribute, RoadId road) const {
    const int lane = element.integer(attribute);
    if (lane < 0 || lane >= static_cast<int>(net_.roads[road].lane_count)) {
      throw element.error(fmt::format("{}='{}': the edge '{}' has {} lanes", attribute, lane,
                                      net_.roads[road].id, net_.roads[road].lane_count));
    }
    return static_cast<std::uint32_t>(lane);
  }

  void read_connection(const xml::Element& element) {
    Connection connection;
    connection.from = connected_road(element, "from");
    connection.to = connected_road(element, "to");
    connection.from_lane = connected_lane(element, "fromLane", connection.from);
    connection.to_lane = connected_lane(element, "toLane", connection.to);
    if (const auto via = element.find("via")) {
      const auto lane = lane_ids_.find(*via);
      if (lane == lane_ids_.end()) throw element.error(fmt::format("via='{}' is no lane of this net", *via));
      connection.via = lane->second;
    }
    const auto direction = element.value_or("dir", "s");
    const auto state = element.value_or("state", "M");
    if (!direction.empty()) connection.direction = direction.front();
    if (!state.empty()) connection.state = state.front();
    if (const auto signal = element.find("tl")) {
      connection.signal = find_signal(*signal);
      connection.link_index = element.find("linkIndex") ? element.integer("linkIndex") : -1;
    }
    connection.permissions = permissions(element, "allow", "disallow");
    net_.connections.push_back(connection);
  }

  void read_junction(const xml::Element& element) {
    if (element.value_or("type", "") == "internal") return;  // a point within a junction, not one of its own
    const JunctionId id = junction(element, element.require("id"));
    if (junction_missing_[id].empty()) throw element.error("there is a junction of this id already");
    junction_missing_[id].clear();
    Junction& described = net_.junctions[id];
    described.type = element.value_or("type", "");
    described.position = {.x = element.number("x"), .y = element.number("y"), .z = element.number_or("z", 0)};
    described.shape = parse_shape(element);
  }

  SignalId find_signal(std::string_view id) {
    const auto [entry, is_new] = signal_ids_.try_emplace(std::string(id), net_.signals.next_id());
    if (is_new) net_.signals.push_back({.id = std::string(id), .programmes = {}});
    return entry->second;
  }

  void read_programme(const xml::Element& element) {
    signal_ = find_signal(element.require("id"));
    net_.signals[signal_].programmes.push_back({.id = std::string(element.value_or("programID", "")),
                                                .type = std::string(element.value_or("type", "static")),
                                                .offset = element.find("offset") ? element.time("offset") : 0,
                                                .phases = {}});
  }

  void read_phase(const xml::Element& element) {
    if (!signal_.valid()) throw element.error("a phase outside of a signal programme");
    net_.signals[signal_].programmes.back().phases.push_back(
        {.duration = element.time("duration"), .state = std::string(element.require("state"))});
  }

  void read_restriction(const xml::Element& element) {
    const auto name = element.require("vClass");
    const auto vehicle_class = parse_vehicle_class(name);
    if (!vehicle_class) {
      net_.warnings.push_back(element.error(fmt::format("the vehicle class '{}' is unknown", name)).what());
      return;
    }
    net_.restrictions.push_back(
        {.type = type_, .vehicle_class = *vehicle_class, .speed = non_negative(element, "speed")});
  }

  void read_roundabout(const xml::Element& element) {
    Roundabout roundabout;
    for (const auto id : split(element.require("nodes"), " "))
      roundabout.junctions.push_back(junction(element, id));
    for (const auto id : split(element.require("edges"), " ")) {
      const auto road = net_.find_road(id);
      if (!road) throw element.error(fmt::format("edges: '{}' is no edge of this net", id));
      roundabout.roads.push_back(*road);
    }
    net_.roundabouts.push_back(std::move(roundabout));
  }

  void read_location(const xml::Element& element) {
    const auto offset = split(element.value_or("netOffset", "0,0"), ",");
    const auto x = !offset.empty() ? parse_number(offset[0]) : std::nullopt;
    const auto y = offset.size() > 1 ? parse_number(offset[1]) : std::nullopt;
    if (!x || !y) throw element.error("netOffset is not a point");
    net_.location = {.net_offset = {.x = *x, .y = *y},
                     .projection = std::string(element.value_or("projParameter", "!")),
                     .converted_boundary = std::string(element.value_or("convBoundary", "")),
                     .original_boundary = std::string(element.value_or("origBoundary", ""))};
  }

  void finish() {
    for (const auto& missing : junction_missing_) {
      if (!missing.empty()) throw InputError(missing);
    }
  }

  Network net_;
  int depth_ = 0;
  bool in_road_ = false;
  std::string road_error_;
  std::string type_;
  SignalId signal_;
  IdVector<JunctionId, std::string> junction_missing_;  ///< the error, until the junction is described
  std::set<std::string> unknown_classes_;
  Network::Names<JunctionId> junction_ids_;
  Network::Names<SignalId> signal_ids_;
  Network::Names<LaneId> lane_ids_;
};

}  // namespace

Network read_network(const std::filesystem::path& file) {
  NetworkHandler handler;
  xml::read(file, handler);
  return handler.take();
}

Network parse_network(std::string_view text) {
  NetworkHandler handler;
  xml::parse(text, "(text)", handler);
  return handler.take();
}

}  // namespace thalweg
