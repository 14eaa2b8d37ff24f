// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/time.hpp"
#include "demand/demand.hpp"
#include "traffic/measured.hpp"

namespace thalweg {

/// A vehicle as it stands now: those on the roads, and those loaded that want to get on one.
struct FleetVehicle {
  enum class State : std::uint8_t { away, waiting, running };
  State state = State::away;
  bool on_junction = false;     ///< it has left route[position] and not yet reached the next
  bool is_lost = false;         ///< not where its route says: teleporting, or re-routed by somebody else
  Millis depart = 0;            ///< as demanded, but not before it was loaded
  std::vector<RoadId> route{};  ///< from its first road to its last
  std::size_t position = 0;     ///< in `route`: the road it is on, or has just left
  LaneId lane{};                ///< of that road; invalid: not seen yet
  double metres = 0;            ///< driven on that road; after a look at positions
  double speed = 0;             ///< m/s
};

/// Everybody's place and intended way: what the forecast starts from. Kept by the control loop.
class Fleet {
 public:
  explicit Fleet(const Demand& demand);

  void on_loaded(VehicleId vehicle, std::span<const RoadId> route, Millis now);
  void on_departed(VehicleId vehicle);
  void on_arrived(VehicleId vehicle);
  /// It drives this from route[position] on.
  void on_route(VehicleId vehicle, std::span<const RoadId> rest);
  /// What it drives from where it is on, as SUMO has it: another way where somebody else re-routed it.
  void on_plan(VehicleId vehicle, std::span<const RoadId> rest);
  /// The vehicles on the roads now. Those not among them are lost until they are seen again.
  void on_observed(const Network& network, std::span<const Observation> observations);

  /// Who was on another road at the last look than at the one before; on its first as well.
  [[nodiscard]] std::span<const VehicleId> entered() const { return entered_; }

  [[nodiscard]] const FleetVehicle& operator[](VehicleId vehicle) const { return vehicles_[vehicle]; }
  [[nodiscard]] std::size_t size() const { return vehicles_.size(); }
  /// Those that are not away, in the order in which they were loaded.
  [[nodiscard]] std::span<const VehicleId> present() const { return present_; }

 private:
  void forget_gone();

  IdVector<VehicleId, FleetVehicle> vehicles_;
  std::vector<VehicleId> present_;
  std::vector<VehicleId> entered_;
  std::size_t gone_ = 0;  ///< of present_, to be removed
};

}  // namespace thalweg
