// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "network/vehicle_class.hpp"
#include "xml/node.hpp"

namespace thalweg {

/// What a route depends on of a vehicle's type.
struct DrivenType {
  std::string id;
  VehicleClass vehicle_class = VehicleClass::passenger;
  double max_speed = 0;  ///< m/s
  double share = 1;      ///< in the distributions it stands in
};

/// The vehicle types of a demand, with SUMO's own.
class VehicleTypes {
 public:
  VehicleTypes();

  /// A <vType> or <vTypeDistribution>, its types within it or named in `vTypes`. InputError: a class, speed
  /// or type that is none.
  void add(const xml::Node& node);
  /// The type of this name; of a distribution the one that belongs to the vehicle, by a hash of its name.
  /// Null: there is none.
  [[nodiscard]] const DrivenType* find(std::string_view type, std::string_view vehicle) const;

 private:
  std::unordered_map<std::string, DrivenType> types_;
  std::unordered_map<std::string, std::vector<DrivenType>> distributions_;
};

}  // namespace thalweg
