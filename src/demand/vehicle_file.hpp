// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <unordered_map>
#include <vector>

#include "demand/demand.hpp"
#include "xml/node.hpp"

namespace thalweg {

using TypeClasses = std::unordered_map<std::string, VehicleClass>;  ///< by id of the type
using RoutesById = std::unordered_map<std::string, std::string>;    ///< `edges` by id of the vehicle

/// The vehicle types that a file and those that it includes define, those in distributions too, with their
/// classes.
void read_types(const std::filesystem::path& file, TypeClasses& types);
/// The types that every SUMO has.
TypeClasses default_types();

/// The routes of a file of vehicles.
RoutesById read_routes(const std::filesystem::path& file);

/// The vehicles of a prepared file, in its order.
void read_vehicles(const std::filesystem::path& file, const Network& network, const TypeClasses& types,
                   Demand& out);

/// A prepared vehicle as the demand has it; reads its attributes and stops only.
DemandVehicle describe_vehicle(const xml::Node& vehicle, const Network& network, const TypeClasses& types);

/// Leaves out the parameters that would hand the vehicle or type to SUMO's own router, and those that name a
/// file for one of its devices (device.ssm.file): the arms share this demand, each run has files of its own.
void strip_parameters(xml::Node& node);

/// The edges of its <route> child; empty when it has none.
std::string route_edges(const xml::Node& vehicle);

}  // namespace thalweg
