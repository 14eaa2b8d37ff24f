// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/time.hpp"
#include "demand/demand.hpp"
#include "traffic/measured.hpp"

namespace thalweg {

/// Who was loaded, inserted and removed in the last step. Vehicles that the demand does not name are not in
/// it.
struct StepEvents {
  std::vector<VehicleId> loaded;
  std::vector<VehicleId> departed;
  std::vector<VehicleId> arrived;
};

/// What SUMO knows of one vehicle's way.
struct Plan {
  std::vector<RoadId> route{};  ///< from the road it is on (on a junction: the one it comes from) to its last
  std::size_t committed = 1;    ///< so many roads at the front can no longer change
  /// So many junctions are near, and it comes to each on a lane that leads to its next road alone.
  std::size_t own_lanes = 0;
  double driven = 0;            ///< share of route.front() that lies behind it, 0 .. 1
  std::vector<RoadId> stops{};  ///< the roads of its stops still ahead, in their order
  bool can_change = true;       ///< false: it is not on the road (teleporting, parked) or its route is odd
};

/// A running simulation, as the control loop needs it. SumoSession is SUMO; tests have one of their own.
class Simulation {
 public:
  virtual ~Simulation() = default;

  [[nodiscard]] virtual Millis now() const = 0;
  [[nodiscard]] virtual Millis step_length() const = 0;
  /// The end that was configured; infinity when there is none.
  [[nodiscard]] virtual Millis end() const = 0;
  /// Nobody is on the way or still to come.
  [[nodiscard]] virtual bool is_empty() const = 0;
  [[nodiscard]] virtual std::size_t running_count() const = 0;

  virtual void step() = 0;
  [[nodiscard]] virtual const StepEvents& events() const = 0;
  /// All vehicles on the roads now, in an order that depends on the run alone.
  virtual std::span<const Observation> observe(Look look) = 0;
  /// The programme that runs at a signal now; without phases where it is switched off.
  virtual SignalProgramme programme(SignalId signal) = 0;
  /// Its id, in far less time.
  virtual std::string programme_id(SignalId signal) = 0;
  /// What a signal shows now.
  virtual ShownPhase phase(SignalId signal) = 0;
  virtual Plan plan(VehicleId vehicle) = 0;
  /// Gives a vehicle the route to drive from the front of its plan's route on. False: SUMO refused it, and
  /// the vehicle keeps its way.
  virtual bool assign(VehicleId vehicle, std::span<const RoadId> route) = 0;
  /// Ends the simulation, so that every output is complete.
  virtual void close() = 0;
};

/// What a session needs to translate between SUMO's names and ids.
struct SessionSetup {
  std::vector<std::string> arguments;  ///< SUMO's, without the program's name
  const Network* network = nullptr;
  const Demand* demand = nullptr;
};

}  // namespace thalweg
