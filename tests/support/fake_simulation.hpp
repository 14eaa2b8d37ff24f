// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "demand/demand.hpp"
#include "simulation/simulation.hpp"
#include "support/ascii_network.hpp"

namespace thalweg::testing {

/// One vehicle of a fake simulation.
struct FakeVehicle {
  std::string id;
  Millis depart = 0;
  std::vector<RoadId> route{};
  std::vector<RoadId> stops{};  ///< it passes them in this order
  std::vector<RoadId> via{};
  VehicleClass vehicle_class = VehicleClass::passenger;
  bool fixed = false;
  bool is_triggered = false;  ///< it has no departure time of its own; the simulation inserts it at `depart`
};

struct FakeOptions {
  Millis step_length = 1'000;
  Millis begin = 0;
  Millis end = infinity;
  Millis load_ahead = infinity;  ///< vehicles are loaded so long before they depart
  Millis insertion_delay = 0;    ///< the road is full: a vehicle enters so much later than it wants to
  double braking_share = 2;      ///< from this share of its road on a vehicle is committed to the next
  double own_lane_share = 2;     ///< from this share of its road on it is on a lane for its turn alone
};

/// What `assign` was told.
struct Assignment {
  Millis time;
  VehicleId vehicle;
  std::vector<RoadId> route;
  bool departed;
};

/// A simulation without SUMO: a vehicle stays on each road of its route for the time that is set for the road
/// (`road_times`, to be changed by the test), and nobody is in anybody's way.
class FakeSimulation : public Simulation {
 public:
  FakeSimulation(const Network& network, std::vector<FakeVehicle> vehicles, const FakeOptions& options = {})
      : road_times(limit_times(network)), network_(network), options_(options), now_(options.begin) {
    for (FakeVehicle& vehicle : vehicles) {
      demand_.vehicles.push_back(
          {.id = vehicle.id,
           .depart = vehicle.is_triggered ? std::nullopt : std::optional(vehicle.depart),
           .vehicle_class = vehicle.vehicle_class,
           .fixed = vehicle.fixed,
           .via = vehicle.via,
           .destination = network.roads[vehicle.route.back()].id});
      states_.push_back({.vehicle = std::move(vehicle)});
    }
    load();
  }

  [[nodiscard]] const Demand& demand() const { return demand_; }

  // What the test may change, and what it finds afterwards.
  RoadTimes road_times;
  std::set<VehicleId> refusing{};  ///< `assign` fails for them
  std::set<VehicleId> away{};      ///< they cannot change now: teleporting, parked
  std::vector<Look> looks;         ///< what `observe` was asked for
  std::vector<Assignment> assignments{};
  IdVector<VehicleId, std::vector<RoadId>> driven{};  ///< the roads each has entered

  [[nodiscard]] Millis now() const override { return now_; }
  [[nodiscard]] Millis step_length() const override { return options_.step_length; }
  [[nodiscard]] Millis end() const override { return options_.end; }
  [[nodiscard]] bool is_empty() const override {
    return std::all_of(states_.begin(), states_.end(), [](const State& s) { return s.is_gone; });
  }
  [[nodiscard]] std::size_t running_count() const override {
    return static_cast<std::size_t>(
        std::count_if(states_.begin(), states_.end(), [](const State& s) { return s.is_running(); }));
  }
  [[nodiscard]] const StepEvents& events() const override { return events_; }

  /// Who wants to depart by now is inserted; then everyone drives for one step.
  void step() override {
    events_ = {};
    const Millis from = now_;
    now_ += options_.step_length;
    for (std::size_t i = 0; i < states_.size(); ++i) {
      State& state = states_[VehicleId{i}];
      if (state.is_loaded && !state.departed && state.vehicle.depart + options_.insertion_delay <= from) {
        state.departed = true;
        state.entered = from;
        events_.departed.emplace_back(i);
        driven_by(VehicleId{i}).push_back(state.vehicle.route.front());
      }
      drive(VehicleId{i});
    }
    load();
  }

  std::span<const Observation> observe(Look look) override {
    looks.push_back(look);
    observations_.clear();
    for (std::size_t i = 0; i < states_.size(); ++i) {
      const State& state = states_[VehicleId{i}];
      if (!state.is_running()) continue;
      const RoadId road = state.road();
      const double speed =
          network_.lanes[network_.roads[road].first_lane].length / to_seconds(road_times[road]);
      observations_.push_back({.road = road,
                               .speed = speed,
                               .vehicle = VehicleId{i},
                               .lane = network_.roads[road].first_lane,
                               .position = speed * to_seconds(now_ - state.entered)});
    }
    return observations_;
  }

  SignalProgramme programme(SignalId /*signal*/) override { return {}; }
  std::string programme_id(SignalId /*signal*/) override { return {}; }
  ShownPhase phase(SignalId /*signal*/) override { return {}; }

  Plan plan(VehicleId vehicle) override {
    const State& state = states_[vehicle];
    Plan plan;
    const auto here = state.vehicle.route.begin() + static_cast<std::ptrdiff_t>(state.position);
    plan.route.assign(here, state.vehicle.route.end());
    plan.driven = state.is_running() ? static_cast<double>(now_ - state.entered) /
                                           static_cast<double>(road_times[state.road()])
                                     : 0;
    plan.committed = plan.driven >= options_.braking_share && plan.route.size() > 1 ? 2 : 1;
    plan.own_lanes = plan.driven >= options_.own_lane_share && plan.route.size() > 1 ? 1 : 0;
    plan.can_change = !away.contains(vehicle);
    // As SUMO: what lies ahead of the stops, in the order of the route.
    auto from = plan.route.begin();
    for (const RoadId stop : state.vehicle.stops) {
      const auto found = std::find(from, plan.route.end(), stop);
      if (found == plan.route.end()) continue;
      plan.stops.push_back(stop);
      from = found;
    }
    return plan;
  }

  bool assign(VehicleId vehicle, std::span<const RoadId> route) override {
    State& state = states_[vehicle];
    assignments.push_back({.time = now_,
                           .vehicle = vehicle,
                           .route = {route.begin(), route.end()},
                           .departed = state.departed});
    const bool fits = !route.empty() && route.front() == state.road() && !state.is_gone;
    if (!fits || refusing.contains(vehicle)) return false;
    state.vehicle.route.resize(state.position);
    state.vehicle.route.insert(state.vehicle.route.end(), route.begin(), route.end());
    return true;
  }

  void close() override {}

 private:
  struct State {
    FakeVehicle vehicle;
    std::size_t position = 0;  ///< in its route
    Millis entered = 0;        ///< when it came onto its road
    bool is_loaded = false;
    bool departed = false;
    bool is_gone = false;
    [[nodiscard]] RoadId road() const { return vehicle.route[position]; }
    [[nodiscard]] bool is_running() const { return departed && !is_gone; }
  };

  std::vector<RoadId>& driven_by(VehicleId vehicle) {
    if (driven.size() < states_.size()) driven.resize(states_.size());
    return driven[vehicle];
  }

  void load() {
    for (std::size_t i = 0; i < states_.size(); ++i) {
      State& state = states_[VehicleId{i}];
      if (state.is_loaded || state.vehicle.depart - now_ > options_.load_ahead) continue;
      state.is_loaded = true;
      events_.loaded.emplace_back(i);
    }
  }

  void drive(VehicleId vehicle) {
    State& state = states_[vehicle];
    while (state.is_running() && now_ - state.entered >= road_times[state.road()]) {
      state.entered += road_times[state.road()];
      if (state.position + 1 == state.vehicle.route.size()) {
        state.is_gone = true;
        events_.arrived.push_back(vehicle);
        return;
      }
      ++state.position;
      driven_by(vehicle).push_back(state.road());
    }
  }

  const Network& network_;
  FakeOptions options_;
  Millis now_;
  Demand demand_;
  IdVector<VehicleId, State> states_;
  StepEvents events_;
  std::vector<Observation> observations_;
};

}  // namespace thalweg::testing
