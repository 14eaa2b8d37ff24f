// SPDX-License-Identifier: Apache-2.0
#include "network/vehicle_class.hpp"

#include <array>

#include "core/number.hpp"

namespace thalweg {
namespace {

struct ClassFacts {
  VehicleClass vehicle_class;
  std::string_view name;
  double max_speed_kmh;
  bool guided = false;
};

using enum VehicleClass;
/// Of SUMO 1.28; who can go faster than he wants to (a bicycle) has the speed that he wants.
constexpr std::array<ClassFacts, 34> facts{{
    {ignoring, "ignoring", 200},
    {private_car, "private", 200},
    {emergency, "emergency", 200},
    {authority, "authority", 200},
    {army, "army", 200},
    {vip, "vip", 200},
    {pedestrian, "pedestrian", 5},
    {passenger, "passenger", 200},
    {hov, "hov", 200},
    {taxi, "taxi", 200},
    {bus, "bus", 100},
    {coach, "coach", 100},
    {delivery, "delivery", 200},
    {truck, "truck", 130},
    {trailer, "trailer", 130},
    {motorcycle, "motorcycle", 200},
    {moped, "moped", 60},
    {bicycle, "bicycle", 20},
    {evehicle, "evehicle", 200},
    {tram, "tram", 80, true},
    {rail_urban, "rail_urban", 100, true},
    {rail, "rail", 160, true},
    {rail_electric, "rail_electric", 220, true},
    {rail_fast, "rail_fast", 330, true},
    {ship, "ship", 8 / 1.94 * 3.6, true},
    {custom1, "custom1", 200},
    {custom2, "custom2", 200},
    {container, "container", 200},
    {cable_car, "cable_car", 200, true},
    {subway, "subway", 100, true},
    {aircraft, "aircraft", 200, true},
    {wheelchair, "wheelchair", 5},
    {scooter, "scooter", 20},
    {drone, "drone", 200},
}};

struct Alias {
  std::string_view name;
  VehicleClass vehicle_class;
};
constexpr std::array<Alias, 11> aliases{{{"public_emergency", emergency},
                                         {"public_authority", authority},
                                         {"public_army", army},
                                         {"public_transport", bus},
                                         {"transport", truck},
                                         {"lightrail", tram},
                                         {"cityrail", rail_urban},
                                         {"rail_slow", rail},
                                         {"car", passenger},
                                         {"hgv", truck},
                                         {"e-vehicle", evehicle}}};

constexpr bool in_order() {
  for (std::size_t i = 0; i < facts.size(); ++i) {
    if (facts[i].vehicle_class != static_cast<VehicleClass>(i)) return false;
  }
  return true;
}
static_assert(in_order(), "facts are looked up by the class's number");

const ClassFacts& of(VehicleClass c) { return facts[static_cast<std::size_t>(c)]; }

Permissions parse_list(std::string_view list, std::vector<std::string>& unknown) {
  Permissions result = Permissions::none();
  for (const auto name : split(list, " \t\r\n,;")) {
    if (name == "all") return Permissions::all();
    if (name == "none") continue;
    if (const auto c = parse_vehicle_class(name)) {
      result.add(*c);
    } else {
      unknown.emplace_back(name);
    }
  }
  return result;
}

}  // namespace

std::string_view name_of(VehicleClass vehicle_class) { return of(vehicle_class).name; }

std::optional<VehicleClass> parse_vehicle_class(std::string_view name) {
  for (const auto& fact : facts) {
    if (fact.name == name) return fact.vehicle_class;
  }
  for (const auto& alias : aliases) {
    if (alias.name == name) return alias.vehicle_class;
  }
  return std::nullopt;
}

double default_max_speed(VehicleClass vehicle_class) { return of(vehicle_class).max_speed_kmh / 3.6; }

bool is_guided(VehicleClass vehicle_class) { return of(vehicle_class).guided; }

Permissions parse_permissions(std::optional<std::string_view> allow, std::optional<std::string_view> disallow,
                              std::vector<std::string>& unknown) {
  if (allow && !trimmed(*allow).empty()) return parse_list(*allow, unknown);
  if (disallow && !trimmed(*disallow).empty()) return parse_list(*disallow, unknown).complement();
  return Permissions::all();
}

}  // namespace thalweg
