// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "traffic/fleet.hpp"

namespace thalweg {

/// What is kept of vehicles until they arrive: a promise, a prediction, the time when a stay began.
template <class T>
class UntilArrival {
 public:
  explicit UntilArrival(std::size_t vehicles) : kept_(vehicles) {}

  [[nodiscard]] bool contains(VehicleId vehicle) const { return kept_[vehicle].has_value(); }
  /// As new where nothing is kept yet.
  T& operator[](VehicleId vehicle) {
    if (!contains(vehicle)) {
      kept_[vehicle] = T{};  // not emplace(): clang has no constructor yet for a T nested in who keeps it
      open_.push_back(vehicle);
    }
    return *kept_[vehicle];
  }
  /// Calls `settle(kept)` for each of those that have arrived, in the order in which they were begun, and
  /// forgets them.
  template <class Settle>
  void settle(const Fleet& fleet, const Settle& settle) {
    std::erase_if(open_, [&](VehicleId vehicle) {
      if (fleet[vehicle].state != FleetVehicle::State::away) return false;
      const std::optional<T> kept = std::exchange(kept_[vehicle], std::nullopt);
      settle(*kept);
      return true;
    });
  }

 private:
  IdVector<VehicleId, std::optional<T>> kept_;
  std::vector<VehicleId> open_;
};

}  // namespace thalweg
