// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/time.hpp"
#include "network/network.hpp"

namespace thalweg {

struct DemandVehicle {
  std::string id;
  std::optional<Millis> depart;  ///< nothing: it waits for a person or a container ("triggered")
  VehicleClass vehicle_class = VehicleClass::passenger;
  bool fixed = false;       ///< public transport and the like: nobody but SUMO touches its route
  std::vector<RoadId> via;  ///< roads that it must pass, in order
  std::string destination;  ///< the last road of its route
};

/// Left out of every arm before the first run, because it has no route.
struct DroppedVehicle {
  std::string id;
  std::string reason;
};

/// The demand as every arm gets it: one file of vehicles with explicit routes.
struct Demand {
  IdVector<VehicleId, DemandVehicle> vehicles;
  std::vector<DroppedVehicle> dropped;
  std::vector<DroppedVehicle> lost_persons{};  ///< and containers, that duarouter left out: no vehicles
};

}  // namespace thalweg
