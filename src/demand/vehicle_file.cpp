// SPDX-License-Identifier: Apache-2.0
#include "demand/vehicle_file.hpp"

#include <algorithm>
#include <functional>

#include "core/number.hpp"
#include "demand/additional.hpp"

namespace thalweg {
namespace {

bool has_taxi_device(const xml::Node& node) {
  return std::any_of(node.children.begin(), node.children.end(), [](const xml::Node& child) {
    return child.name == "param" && child.value_or("key", "") == "has.taxi.device" &&
           child.value_or("value", "") == "true";
  });
}

void add_type(const xml::Node& node, TypeClasses& types) {
  if (node.name == "vType") {
    const auto known = parse_vehicle_class(node.value_or("vClass", "passenger"));
    // A taxi is one by its device as well.
    types[node.require("id")] =
        has_taxi_device(node) ? VehicleClass::taxi : known.value_or(VehicleClass::passenger);
  }
  if (node.name == "vTypeDistribution" && node.find("id") != nullptr) {
    types.try_emplace(node.require("id"), VehicleClass::passenger);
  }
  if (node.name == "vTypeDistribution") {
    for (const xml::Node& child : node.children) add_type(child, types);
  }
}

bool is_public_transport(const xml::Node& vehicle, VehicleClass vehicle_class) {
  const bool has_stops = std::any_of(vehicle.children.begin(), vehicle.children.end(),
                                     [](const xml::Node& child) { return child.name == "stop"; });
  const bool is_bus = vehicle_class == VehicleClass::bus || vehicle_class == VehicleClass::coach;
  return vehicle.find("line") != nullptr || is_guided(vehicle_class) || vehicle_class == VehicleClass::taxi ||
         has_taxi_device(vehicle) || vehicle_class == VehicleClass::pedestrian || (is_bus && has_stops);
}

}  // namespace

void read_types(const std::filesystem::path& file, TypeClasses& types) {
  xml::read_nodes_and_included(
      file, [&](const xml::Node& node, const std::filesystem::path&) { add_type(node, types); });
}

TypeClasses default_types() {
  return {{"DEFAULT_VEHTYPE", VehicleClass::passenger},  {"DEFAULT_BIKETYPE", VehicleClass::bicycle},
          {"DEFAULT_TAXITYPE", VehicleClass::taxi},      {"DEFAULT_RAILTYPE", VehicleClass::rail},
          {"DEFAULT_PEDTYPE", VehicleClass::pedestrian}, {"DEFAULT_CONTAINERTYPE", VehicleClass::container}};
}

std::string route_edges(const xml::Node& vehicle) {
  for (const xml::Node& child : vehicle.children) {
    if (child.name == "route") return std::string(child.value_or("edges", ""));
  }
  return {};
}

RoutesById read_routes(const std::filesystem::path& file) {
  RoutesById routes;
  xml::read_nodes(file, [&](const xml::Node& node) {
    if (node.name == "vehicle") routes.emplace(node.require("id"), route_edges(node));
  });
  return routes;
}

DemandVehicle describe_vehicle(const xml::Node& vehicle, const Network& network, const TypeClasses& types) {
  DemandVehicle described;
  described.id = vehicle.require("id");
  described.depart = parse_time(vehicle.value_or("depart", ""));
  const auto type = types.find(std::string(vehicle.value_or("type", "DEFAULT_VEHTYPE")));
  if (type != types.end()) described.vehicle_class = type->second;
  described.fixed = !described.depart || is_public_transport(vehicle, described.vehicle_class);
  for (const auto road : split(vehicle.value_or("via", ""), " \t\r\n")) {
    if (const auto found = network.find_road(road)) described.via.push_back(*found);
  }
  const std::string edges = route_edges(vehicle);
  if (const auto roads = split(edges, " "); !roads.empty()) described.destination = roads.back();
  return described;
}

void read_vehicles(const std::filesystem::path& file, const Network& network, const TypeClasses& types,
                   Demand& out) {
  TypeClasses known = types;
  read_types(file, known);
  xml::read_nodes(file, [&](const xml::Node& node) {
    if (node.name == "vehicle") out.vehicles.push_back(describe_vehicle(node, network, known));
  });
}

void strip_parameters(xml::Node& node) {
  std::erase_if(node.children, [](const xml::Node& child) {
    const auto key = child.value_or("key", "");
    const bool names_file = key.starts_with("device.") && key.ends_with(".file");
    return child.name == "param" && (names_file || switches_rerouting(key));
  });
  for (xml::Node& child : node.children) strip_parameters(child);
}

}  // namespace thalweg
