// SPDX-License-Identifier: Apache-2.0
// The only file that includes libsumo. What differs between SUMO's versions is settled here.
#include <fmt/format.h>
#include <libsumo/libsumo.h>

#include <unordered_map>

#include "core/error.hpp"
#include "core/number.hpp"
#include "network/lane_targets.hpp"
#include "simulation/sumo_module.hpp"

namespace thalweg {
namespace {

/// SUMO's decel where a type says nothing (m/s^2); used for the distance within which a turn is committed.
constexpr double usual_deceleration = 4.5;

/// m before a junction within which one does not leave the lane for its turn, on whatever road it is yet:
/// among those who wait there it would stand across two lanes, and two that want each other's lane wait for
/// ever.
constexpr double lanes_kept = 100;

/// Vehicles loaded before the first step; libsumo tells them since 1.20 or so.
template <class SumoVehicle>
std::vector<std::string> loaded_at_start() {
  if constexpr (requires { SumoVehicle::getLoadedIDList(); }) return SumoVehicle::getLoadedIDList();
  return {};
}

/// SUMO warns each time a mesoscopic vehicle is asked whether it stands at a stop.
template <class SumoSimulation>
bool is_mesoscopic() {
  if constexpr (requires { SumoSimulation::getOption(std::string()); })
    return SumoSimulation::getOption("mesosim") == "true";
  return false;
}

class SumoSession : public Simulation {
 public:
  explicit SumoSession(const SessionSetup& setup)
      : network_(*setup.network),
        demand_(*setup.demand),
        lane_targets_(lane_targets(network_)),
        routes_(setup.demand->vehicles.size()) {
    for (std::size_t i = 0; i < demand_.vehicles.size(); ++i) {
      ids_.emplace(demand_.vehicles[VehicleId{i}].id, VehicleId{i});
    }
    std::vector<std::string> command{"sumo"};
    command.insert(command.end(), setup.arguments.begin(), setup.arguments.end());
    guarded([&] { libsumo::Simulation::start(command); });
    step_length_ = from_seconds(libsumo::Simulation::getDeltaT());
    const double end = libsumo::Simulation::getEndTime();
    end_ = end < 0 ? infinity : from_seconds(end);
    now_ = from_seconds(libsumo::Simulation::getTime());
    is_mesoscopic_ = is_mesoscopic<libsumo::Simulation>();
    on_loaded(loaded_at_start<libsumo::Vehicle>());
    on_departed(libsumo::Vehicle::getIDList());  // of a state that was loaded
  }
  SumoSession(const SumoSession&) = delete;
  SumoSession& operator=(const SumoSession&) = delete;
  ~SumoSession() override {
    try {
      close();
    } catch (const std::exception&) {  // the first failure is the one that is told
      static_cast<void>(0);
    }
  }

  [[nodiscard]] Millis now() const override { return now_; }
  [[nodiscard]] Millis step_length() const override { return step_length_; }
  [[nodiscard]] Millis end() const override { return end_; }
  [[nodiscard]] bool is_empty() const override { return libsumo::Simulation::getMinExpectedNumber() <= 0; }
  [[nodiscard]] std::size_t running_count() const override { return running_.size(); }
  [[nodiscard]] const StepEvents& events() const override { return events_; }

  void step() override {
    guarded([&] {
      libsumo::Simulation::step();
      now_ = from_seconds(libsumo::Simulation::getTime());
      on_loaded(libsumo::Simulation::getLoadedIDList());
      on_departed(libsumo::Simulation::getDepartedIDList());
      const auto arrived = libsumo::Simulation::getArrivedIDList();
      for (const auto& name : arrived) forget(name);
      resolve(arrived, events_.arrived);
      for (const VehicleId vehicle : events_.arrived) routes_[vehicle] = {};
    });
  }

  std::span<const Observation> observe(Look look) override {
    const bool by_lane = look != Look::roads && !is_mesoscopic_;  // who is mesoscopic is on no lane
    observations_.clear();
    for (std::size_t i = 0; i < running_.size();) {
      try {
        Running& vehicle = running_[i];
        if (by_lane ? look_at_lane(vehicle) : look_at_road(vehicle)) {
          Observation& seen = observations_.back();
          seen.speed = libsumo::Vehicle::getSpeed(vehicle.name);
          if (look == Look::positions) seen.position = libsumo::Vehicle::getLanePosition(vehicle.name);
        }
        ++i;
      } catch (const libsumo::TraCIException&) {
        forget(std::string(running_[i].name));  // gone without an arrival
      }
    }
    return observations_;
  }

  SignalProgramme programme(SignalId signal) override {
    const std::string& id = network_.signals[signal].id;
    SignalProgramme programme{.id = programme_id(signal), .type = {}, .offset = 0, .phases = {}};
    try {
      for (const auto& logic : libsumo::TrafficLight::getAllProgramLogics(id)) {
        if (logic.programID != programme.id) continue;
        for (const auto& phase : logic.phases)
          programme.phases.push_back({.duration = from_seconds(phase->duration), .state = phase->state});
        if (logic.type == fixed_lengths && !is_mesoscopic_)  // who is mesoscopic mostly ignores them
          programme.cycle_start = cycle_start(id, logic.currentPhaseIndex, programme.phases);
        programme.follows_traffic = follows_traffic(logic.type) && !is_mesoscopic_;
      }
    } catch (const libsumo::TraCIException&) {  // a rail signal, or not in this net
      programme.phases.clear();
    }
    return programme;
  }
  std::string programme_id(SignalId signal) override {
    try {
      return libsumo::TrafficLight::getProgram(network_.signals[signal].id);
    } catch (const libsumo::TraCIException&) {
      return {};
    }
  }

  ShownPhase phase(SignalId signal) override {
    const std::string& id = network_.signals[signal].id;
    return {.index = static_cast<std::size_t>(libsumo::TrafficLight::getPhase(id)),
            .since = now() - from_seconds(libsumo::TrafficLight::getSpentDuration(id))};
  }

  Plan plan(VehicleId vehicle) override {
    Plan plan;
    plan.can_change = false;
    try {
      fill(vehicle, plan);
    } catch (const libsumo::TraCIException&) {
      plan.can_change = false;  // discarded in the meantime
    }
    return plan;
  }

  bool assign(VehicleId vehicle, std::span<const RoadId> route) override {
    std::vector<std::string> edges;
    edges.reserve(route.size());
    for (const RoadId road : route) edges.push_back(network_.roads[road].id);
    try {
      libsumo::Vehicle::setRoute(demand_.vehicles[vehicle].id, edges);
      return true;
    } catch (const libsumo::TraCIException&) {
      return false;
    }
  }

  void close() override {
    if (closed_) return;
    closed_ = true;
    guarded([] { libsumo::Simulation::close("Simulation ended by thalweg."); });
  }

 private:
  static constexpr int fixed_lengths = 0;  // of TraCILogic::type: TrafficLightType::STATIC
  static bool follows_traffic(int type) {
    return type == libsumo::TRAFFICLIGHT_TYPE_ACTUATED || type == libsumo::TRAFFICLIGHT_TYPE_DELAYBASED;
  }

  static Millis cycle_start(const std::string& signal, int index, std::span<const SignalPhase> phases) {
    Millis end_of_phase = 0;  // in the cycle
    for (const SignalPhase& phase : phases.first(static_cast<std::size_t>(index) + 1))
      end_of_phase += phase.duration;
    return from_seconds(libsumo::TrafficLight::getNextSwitch(signal)) - end_of_phase;
  }

  struct Running {
    std::string name;
    VehicleId id;   ///< invalid: not of the demand
    RoadId road{};  ///< where it was seen last
  };

  struct KnownRoute {
    std::string id;
    std::vector<RoadId> roads;
  };

  /// SUMO's failures come out in its own words.
  template <class Action>
  static void guarded(Action action) {
    try {
      action();
    } catch (const std::exception& error) {  // TraCI's, SUMO's own ProcessError, std::bad_alloc ..
      throw InputError(fmt::format("SUMO: {}", error.what()));
    }
  }

  /// SUMO reads `via` of trips and flows only: without this its own router would forget the way points of a
  /// vehicle that comes with a route.
  void on_loaded(const std::vector<std::string>& names) {
    resolve(names, events_.loaded);
    for (const VehicleId loaded : events_.loaded) {
      const DemandVehicle& vehicle = demand_.vehicles[loaded];
      if (vehicle.via.empty()) continue;
      std::vector<std::string> roads;
      for (const RoadId road : vehicle.via) roads.push_back(network_.roads[road].id);
      libsumo::Vehicle::setVia(vehicle.id, roads);
    }
  }

  void on_departed(const std::vector<std::string>& names) {
    resolve(names, events_.departed);
    for (const auto& name : names) {
      const auto known = ids_.find(name);
      places_.emplace(name, running_.size());
      running_.push_back({.name = name, .id = known == ids_.end() ? VehicleId{} : known->second});
    }
  }

  void resolve(const std::vector<std::string>& names, std::vector<VehicleId>& out) const {
    out.clear();
    for (const auto& name : names) {
      const auto found = ids_.find(name);
      if (found != ids_.end()) out.push_back(found->second);
    }
  }

  void forget(const std::string& name) {
    const auto place = places_.find(name);
    if (place == places_.end()) return;
    const std::size_t index = place->second;
    places_.erase(place);
    if (index + 1 != running_.size()) {
      running_[index] = std::move(running_.back());
      places_[running_[index].name] = index;
    }
    running_.pop_back();
  }

  /// The road of this name; mostly the one where the vehicle was seen last. False: none (teleporting).
  bool find(std::string_view name, Running& vehicle) const {
    if (vehicle.road.valid() && network_.roads[vehicle.road].id == name) return true;
    vehicle.road = network_.find_road(name).value_or(RoadId{});
    return vehicle.road.valid();
  }
  bool look_at_road(Running& vehicle) {
    if (!find(libsumo::Vehicle::getRoadID(vehicle.name), vehicle)) return false;
    observations_.push_back({.road = vehicle.road, .vehicle = vehicle.id});
    if (is_mesoscopic_) {  // any lane, so that queues are spread over all
      const Road& road = network_.roads[vehicle.road];
      observations_.back().lane = road.lane(vehicle.id.value % road.lane_count);
    }
    return true;
  }
  bool look_at_lane(Running& vehicle) {
    const std::string name = libsumo::Vehicle::getLaneID(vehicle.name);
    const auto mark = name.rfind('_');
    if (mark == std::string::npos || !find(std::string_view(name).substr(0, mark), vehicle)) return false;
    const Road& road = network_.roads[vehicle.road];
    const auto index = parse_integer<std::uint32_t>(std::string_view(name).substr(mark + 1));
    if (!index || *index >= road.lane_count) return false;
    observations_.push_back({.road = vehicle.road, .vehicle = vehicle.id, .lane = road.lane(*index)});
    return true;
  }

  /// All roads of its route; empty when one of them is not in the network. SUMO gives each route of a
  /// vehicle an id of its own, so that the roads are asked for once.
  const std::vector<RoadId>& route_of(VehicleId vehicle, const std::string& name) {
    KnownRoute& known = routes_[vehicle];
    std::string id = libsumo::Vehicle::getRouteID(name);
    if (id == known.id) return known.roads;
    known.id = std::move(id);
    known.roads.clear();
    for (const auto& edge : libsumo::Vehicle::getRoute(name)) {
      const auto road = network_.find_road(edge);
      if (!road) {
        known.roads.clear();
        break;
      }
      known.roads.push_back(*road);
    }
    return known.roads;
  }

  void fill(VehicleId vehicle, Plan& plan) {
    const std::string& name = demand_.vehicles[vehicle].id;
    const std::vector<RoadId>& roads = route_of(vehicle, name);
    const bool departed = places_.contains(name);
    const int index = departed ? libsumo::Vehicle::getRouteIndex(name) : 0;
    if (index < 0 || static_cast<std::size_t>(index) >= roads.size()) return;
    plan.route.assign(roads.begin() + index, roads.end());
    if (departed && !locate(name, plan)) return;
    for (const auto& stop : libsumo::Vehicle::getStops(name)) {
      const auto road = network_.find_road(std::string_view(stop.lane).substr(0, stop.lane.rfind('_')));
      if (!road) return;
      plan.stops.push_back(*road);
    }
    plan.can_change = true;
  }

  /// Where on its route the vehicle is and what is committed; false when it is not on it.
  bool locate(const std::string& name, Plan& plan) const {
    const std::string road = libsumo::Vehicle::getRoadID(name);
    const bool stands = !is_mesoscopic_ && libsumo::Vehicle::getStopState(name) != 0;
    if (road.empty() || stands) return false;
    if (road.front() == ':') {
      plan.committed = 2;
      plan.driven = 1;
      return true;
    }
    const RoadId current = plan.route.front();
    if (network_.roads[current].id != road) return false;
    const double length = network_.lanes[network_.roads[current].first_lane].length;
    const double position = libsumo::Vehicle::getLanePosition(name);
    const double speed = libsumo::Vehicle::getSpeed(name);
    const double braking = speed * speed / (2 * usual_deceleration) + speed * to_seconds(step_length_);
    plan.driven = length > 0 ? std::clamp(position / length, 0.0, 1.0) : 1.0;
    plan.committed = length - position < braking ? 2 : 1;
    if (!is_mesoscopic_) count_own_lanes(libsumo::Vehicle::getLaneIndex(name), length - position, plan);
    return true;
  }

  /// `left`: m of its road.
  void count_own_lanes(int index, double left, Plan& plan) const {
    const Road& road = network_.roads[plan.route.front()];
    if (index < 0 || static_cast<std::uint32_t>(index) >= road.lane_count) return;
    LaneId lane = road.lane(static_cast<std::uint32_t>(index));
    while (left < lanes_kept && plan.own_lanes + 1 < plan.route.size()) {
      const LaneTarget& target = lane_targets_[lane];
      if (target.road != plan.route[plan.own_lanes + 1]) return;
      ++plan.own_lanes;
      lane = target.lane;
      left += network_.lanes[lane].length;
    }
  }

  const Network& network_;
  const Demand& demand_;
  IdVector<LaneId, LaneTarget> lane_targets_;
  std::unordered_map<std::string, VehicleId> ids_;
  std::vector<Running> running_;
  std::unordered_map<std::string, std::size_t> places_;  ///< in running_
  IdVector<VehicleId, KnownRoute> routes_;  ///< of those that were asked for and are on their way
  std::vector<Observation> observations_;
  StepEvents events_;
  Millis now_ = 0;
  Millis step_length_ = 1000;
  Millis end_ = infinity;
  bool is_mesoscopic_ = false;
  bool closed_ = false;
};

}  // namespace
}  // namespace thalweg

extern "C" thalweg::Simulation* thalweg_open_sumo(const thalweg::SessionSetup& setup) {
  return new thalweg::SumoSession(setup);
}

extern "C" const char* thalweg_sumo_version() {
  static const std::string version = libsumo::Simulation::getVersion().second;
  return version.c_str();
}
