// SPDX-License-Identifier: Apache-2.0
#include "demand/input_scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/number.hpp"
#include "xml/node.hpp"

namespace thalweg {
namespace {

/// The first road named by the vehicle, its route or its stops that the net has not; empty when there is
/// none.
std::string unknown_road(const xml::Node& node, const Network& network) {
  static constexpr std::array<std::string_view, 5> lists{"from", "to", "via", "edges", "edge"};
  for (const auto attribute : lists) {
    for (const auto road : split(node.value_or(attribute, ""), " \t\r\n")) {
      if (!network.find_road(road)) return std::string(road);
    }
  }
  for (const xml::Node& child : node.children) {
    if (child.name == "param") continue;
    if (auto road = unknown_road(child, network); !road.empty()) return road;
  }
  return {};
}

/// The same for the routes that it names: duarouter leaves an unknown road out of a route and drives the
/// rest.
std::string unknown_road_of_routes(const xml::Node& node, const InputScan& scan) {
  for (const auto* const names : {"route", "routes", "refId"}) {  // the last two: within a distribution
    for (const auto route : split(node.value_or(names, ""), " \t\r\n")) {
      const auto broken = scan.broken_routes.find(std::string(route));
      if (broken != scan.broken_routes.end()) return broken->second;
    }
  }
  for (const xml::Node& child : node.children) {
    if (auto road = unknown_road_of_routes(child, scan); !road.empty()) return road;
  }
  return {};
}

/// Empty: all that it drives is in the net.
std::string missing_road(const xml::Node& node, const Network& network, const InputScan& scan) {
  auto road = unknown_road(node, network);
  return road.empty() ? unknown_road_of_routes(node, scan) : road;
}

/// A <route> or <routeDistribution> of its own. False: it is broken, and so is whoever drives it.
bool note_route(const xml::Node& node, const Network& network, InputScan& scan) {
  const auto road = missing_road(node, network, scan);
  if (road.empty()) return true;
  if (const std::string* id = node.find("id")) scan.broken_routes.emplace(*id, road);
  for (const xml::Node& route : node.children) {
    if (const std::string* id = route.find("id")) scan.broken_routes.emplace(*id, road);
  }
  return false;
}

/// A vehicle, trip or flow that is over before the simulation begins; a flow that goes on is cut there.
/// SUMO's duarouter (1.28) never returns from a flow by probability that begins before.
bool is_over(xml::Node& node, Millis begin) {
  const bool is_flow = node.name == "flow";
  const auto start = parse_time(node.value_or(is_flow ? "begin" : "depart", ""));
  if (!start || *start < 0 || *start >= begin) return false;  // duarouter has its words for less than 0
  const auto end = parse_time(node.value_or("end", ""));
  if (!is_flow || (end && *end <= begin)) return true;
  if (node.find("probability") != nullptr) node.set("begin", format_seconds(begin));
  return false;
}

/// A flow of vehicles, persons or containers that does not say when it ends does so with the simulation, as
/// in SUMO. (duarouter's `--end` would leave out the vehicles that are due later, too.)
void close_flow(xml::Node& node, Millis end) {
  const bool is_flow = node.name == "flow" || node.name == "personFlow" || node.name == "containerFlow";
  if (is_flow && end >= 0 && node.find("end") == nullptr && node.find("number") == nullptr)
    node.set("end", format_seconds(end));
}

bool has_route(const xml::Node& node) {
  return node.find("route") != nullptr ||
         std::any_of(node.children.begin(), node.children.end(), [](const xml::Node& child) {
           return child.name == "route" || child.name == "routeDistribution";
         });
}

/// False: the vehicle, trip or flow is to be left out.
bool note(xml::Node& node, const Network& network, InputScan& scan) {
  const std::string& id = node.require("id");
  const bool is_flow = node.name == "flow";
  if (!(is_flow ? scan.seen_flows : scan.seen).insert(id).second) {
    throw node.error(is_flow ? "there is a flow of this id already"
                             : "there is a vehicle or trip of this id already");
  }
  if (is_over(node, scan.begin)) return false;
  if (const auto road = missing_road(node, network, scan); !road.empty()) {
    const auto reason = fmt::format("the edge '{}' is not in the net", road);
    const auto number = parse_integer<int>(node.value_or("number", ""));
    if (!is_flow || !number) {
      scan.dropped.push_back({.id = id, .reason = is_flow ? "the whole flow: " + reason : reason});
    }
    for (int i = 0; is_flow && number && i < *number; ++i) {
      scan.dropped.push_back({.id = fmt::format("{}.{}", id, i), .reason = reason});
    }
    return false;
  }
  if (const std::string* via = node.find("via")) (is_flow ? scan.via_of_flows : scan.via).emplace(id, *via);
  (is_flow ? scan.flows : scan.ids).push_back(id);
  if (has_route(node)) scan.has_given_routes = true;
  return true;
}

/// What `scan_demand` does, into an open file. True: there was demand in it.
bool scan_into(xml::Writer& writer, const std::filesystem::path& file, const Network& network,
               bool is_additional, InputScan& scan) {
  bool found = false;
  xml::read_nodes_and_included(
      file,
      [&](const xml::Element& root) {
        if (!is_additional && (root.name() == "net" || root.name() == "configuration")) {
          throw root.error("this is no route file: its root should be <routes>");
        }
      },
      [&](xml::Node& node, const std::filesystem::path&) {
        const bool is_route = node.name == "route" || node.name == "routeDistribution";
        if (is_route && !note_route(node, network, scan)) return;
        const bool is_demand = is_demand_element(node.name);
        const bool is_vehicle = node.name == "vehicle" || node.name == "trip" || node.name == "flow";
        const bool inserts = is_additional && node.name == "calibrator";
        scan.has_others = scan.has_others || (is_demand && !is_vehicle) || inserts;
        if (is_additional && !is_demand) return;  // duarouter reads the rest of the additional file itself
        found = found || is_demand;
        close_flow(node, scan.end);
        if (!is_vehicle || note(node, network, scan)) write_node(writer, node);
      });
  return found;
}

}  // namespace

bool is_demand_element(std::string_view element) {
  static constexpr std::array<std::string_view, 7> elements{
      "vehicle", "trip", "flow", "person", "personFlow", "container", "containerFlow"};
  return std::find(elements.begin(), elements.end(), element) != elements.end();
}

bool scan_demand(const std::filesystem::path& file, const std::filesystem::path& copy, const Network& network,
                 bool is_additional, InputScan& scan) {
  xml::Writer writer(copy, fmt::format("from {}", file.filename().string()));
  writer.open("routes");
  const bool found = scan_into(writer, file, network, is_additional, scan);
  if (is_additional && !found) return false;
  writer.commit();
  return true;
}

}  // namespace thalweg
