// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace thalweg {

/// SUMO's vehicle classes
/// (sumo.dlr.de/docs/Definition_of_Vehicles,_Vehicle_Types,_and_Routes.html#abstract_vehicle_class).
/// `ignoring` may drive wherever there is a connection.
enum class VehicleClass : std::uint8_t {
  ignoring,
  private_car,
  emergency,
  authority,
  army,
  vip,
  pedestrian,
  passenger,
  hov,
  taxi,
  bus,
  coach,
  delivery,
  truck,
  trailer,
  motorcycle,
  moped,
  bicycle,
  evehicle,
  tram,
  rail_urban,
  rail,
  rail_electric,
  rail_fast,
  ship,
  custom1,
  custom2,
  container,
  cable_car,
  subway,
  aircraft,
  wheelchair,
  scooter,
  drone,
};

/// SUMO's name of the class ("passenger"), and the way back; names of before 0.21 are understood as well.
std::string_view name_of(VehicleClass vehicle_class);
std::optional<VehicleClass> parse_vehicle_class(std::string_view name);

/// The speed that a type of this class does not exceed by default, in m/s (SUMO's vehicle type defaults).
double default_max_speed(VehicleClass vehicle_class);

/// Trains, trams, ships and the like: nothing that could choose its way through streets.
bool is_guided(VehicleClass vehicle_class);

/// A set of vehicle classes, as `allow` and `disallow` say.
class Permissions {
 public:
  static constexpr Permissions all() { return Permissions(~std::uint64_t{0}); }
  static constexpr Permissions none() { return Permissions(0); }

  [[nodiscard]] constexpr bool allows(VehicleClass c) const {
    return c == VehicleClass::ignoring || ((bits_ >> static_cast<unsigned>(c)) & 1U) != 0;
  }
  constexpr void add(VehicleClass c) { bits_ |= std::uint64_t{1} << static_cast<unsigned>(c); }
  [[nodiscard]] constexpr Permissions complement() const { return Permissions(~bits_); }
  friend constexpr Permissions operator&(Permissions a, Permissions b) {
    return Permissions(a.bits_ & b.bits_);
  }
  friend constexpr Permissions operator|(Permissions a, Permissions b) {
    return Permissions(a.bits_ | b.bits_);
  }
  bool operator==(const Permissions&) const = default;

 private:
  constexpr explicit Permissions(std::uint64_t bits) : bits_(bits) {}
  std::uint64_t bits_;
};

/// What a lane permits: `allow` if it is given, else all but `disallow`. Names that nobody knows are added to
/// `unknown` and otherwise left out.
Permissions parse_permissions(std::optional<std::string_view> allow, std::optional<std::string_view> disallow,
                              std::vector<std::string>& unknown);

}  // namespace thalweg
