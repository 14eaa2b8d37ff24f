// SPDX-License-Identifier: Apache-2.0
#include "simulation/control.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <optional>

#include "core/hash.hpp"
#include "simulation/agenda.hpp"
#include "simulation/live_traffic.hpp"
#include "simulation/signal_watch.hpp"
#include "simulation/traveller.hpp"
#include "traffic/conditions.hpp"

namespace thalweg {
namespace {

double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

class Controller {
 public:
  Controller(Simulation& simulation, const Network& network, const Demand& demand, Strategy& strategy,
             const ControlOptions& options, RunResult& result)
      : simulation_(simulation),
        network_(network),
        demand_(demand),
        strategy_(strategy),
        options_(options),
        result_(result),
        agenda_(demand, options.period, options.share, strategy.looks_ahead()),
        sample_interval_(std::max(options.sample_interval, simulation.step_length())),
        measured_(network, options.window, sample_interval_),
        conditions_(network, options.lane_changes),
        fleet_(demand),
        signals_(network.signals.size()),
        ledger_(demand.vehicles.size(), result.forecast_error),
        last_questions_(demand.vehicles.size()),
        traffic_(network, demand, options.penalties) {
    next_sample_ = simulation.now();
  }

  /// After a step (and before the first): notes what happened, and lets those who are due decide.
  void update() {
    for (const VehicleId vehicle : simulation_.events().loaded) {
      agenda_.on_loaded(vehicle, simulation_.now());
      if (strategy_.looks_ahead())
        fleet_.on_loaded(vehicle, simulation_.plan(vehicle).route, simulation_.now());
    }
    for (const VehicleId vehicle : simulation_.events().departed) {
      agenda_.on_departed(vehicle, simulation_.now());
      fleet_.on_departed(vehicle);
    }
    for (const VehicleId vehicle : simulation_.events().arrived) {
      agenda_.on_arrived(vehicle);
      fleet_.on_arrived(vehicle);
      ledger_.arrived(vehicle, simulation_.now());
    }
    if (conditions_.advance(simulation_.now())) {  // another world: earlier answers count no more
      next_adaptation_ = simulation_.now();
      std::fill(last_questions_.begin(), last_questions_.end(), Question{});
    }
    between_turns_.clear();
    if (simulation_.now() >= next_sample_) {
      const auto observations = simulation_.observe(strategy_.next_look(simulation_.now()));
      measured_.sample(observations);
      if (strategy_.looks_ahead()) {
        watch(observations);
        ++news_;
      }
      next_sample_ += sample_interval_;  // not from now on: steps of 0.3 s would make 1.2 s of 1 s
    }
    if (simulation_.now() >= next_adaptation_) {
      traffic_.expire();
      ++news_;
      next_adaptation_ = simulation_.now() + options_.adaptation_interval;
    }
    agenda_.take_due(simulation_.now(), due_);
    if (!due_.empty() || !between_turns_.empty()) decide();
  }

 private:
  /// What a vehicle was asked last.
  struct Question {
    RoadId from{};            ///< the first road that could change
    std::uint32_t news = 0;   ///< news_ at that time
    bool had_answer = false;  ///< there was a way
  };

  void watch(std::span<const Observation> observations) {
    fleet_.on_observed(network_, observations);
    find_lost(observations);
    signals_.look(simulation_);
    strategy_.watch({.now = simulation_.now(),
                     .network = network_,
                     .demand = demand_,
                     .fleet = fleet_,
                     .measured = measured_,
                     .observations = observations,
                     .conditions = conditions_,
                     .programmes = signals_.programmes(),
                     .changed_signals = signals_.changed(),
                     .following = signals_.following()});
    for (const VehicleId vehicle : fleet_.entered()) {
      const FleetVehicle& own = fleet_[vehicle];
      if (agenda_.ours(vehicle) && agenda_.departed(vehicle) && strategy_.asks_on(own.route[own.position]))
        between_turns_.push_back(vehicle);
    }
  }

  /// Those that a rerouter of SUMO's sent another way are seen again after the next look.
  void find_lost(std::span<const Observation> observations) {
    for (const Observation& seen : observations) {
      if (!seen.vehicle.valid() || !fleet_[seen.vehicle].is_lost) continue;
      const Plan plan = simulation_.plan(seen.vehicle);
      if (!plan.route.empty()) fleet_.on_plan(seen.vehicle, plan.route);
    }
  }

  void decide() {
    travellers_.clear();
    plans_.clear();
    for (const VehicleId vehicle : due_) {
      agenda_.reschedule(vehicle, simulation_.now());
      add_traveller(vehicle);
    }
    for (const VehicleId vehicle : between_turns_) {
      if (!std::binary_search(due_.begin(), due_.end(), vehicle)) add_traveller(vehicle);
    }
    if (travellers_.empty()) return;
    for (const Traveller& traveller : travellers_)
      traffic_.refresh(traveller.vehicle_class, measured_, conditions_);
    for (std::size_t i = 0; i < travellers_.size(); ++i)
      travellers_[i].until_route = until_route(travellers_[i], plans_[i]);
    strategy_.decide(traffic_.all(), travellers_, decisions_);
    result_.decisions += travellers_.size();
    for (std::size_t i = 0; i < travellers_.size(); ++i) apply(travellers_[i], plans_[i], decisions_[i]);
    strategy_.applied(travellers_, decisions_);
  }

  void add_traveller(VehicleId vehicle) {
    Plan plan = simulation_.plan(vehicle);
    const DemandVehicle& wanted = demand_.vehicles[vehicle];
    for (std::size_t i = 1; i <= plan.own_lanes; ++i) {
      if (conditions_.closed(plan.route[i], wanted.vehicle_class)) break;
      plan.committed = std::max(plan.committed, i + 1);
    }
    if (!plan.can_change || plan.committed >= plan.route.size()) return;
    if (strategy_.looks_ahead()) fleet_.on_plan(vehicle, plan.route);
    // The same question has the same answer; where there was no way, new costs do not bring one.
    const Question& last = last_questions_[vehicle];
    if (last.from == plan.route[plan.committed - 1] && (last.news == news_ || !last.had_answer)) return;
    const std::size_t vehicle_class = traffic_.index_of(wanted.vehicle_class);
    std::optional<Traveller> traveller = make_traveller(plan, wanted, traffic_.graph(vehicle_class));
    if (!traveller) return;
    traveller->vehicle = vehicle;
    traveller->vehicle_class = vehicle_class;
    traveller->departed = agenda_.departed(vehicle);
    travellers_.push_back(*std::move(traveller));
    plans_.push_back(std::move(plan));
  }

  [[nodiscard]] Millis until_route(const Traveller& traveller, const Plan& plan) const {
    Millis until_depart = 0;
    if (!traveller.departed) {
      const auto depart = demand_.vehicles[traveller.vehicle].depart;
      until_depart = std::max<Millis>(0, depart.value_or(simulation_.now()) - simulation_.now());
    }
    return until_free_turn(plan, until_depart, traffic_[traveller.vehicle_class].road_times);
  }

  void apply(const Traveller& traveller, const Plan& plan, Decision& decision) {
    const RoadGraph& graph = traffic_.graph(traveller.vehicle_class);
    const bool has_way = !decision.route.empty();
    last_questions_[traveller.vehicle] = {
        .from = plan.route[plan.committed - 1], .news = news_, .had_answer = has_way};
    if (!has_way) ++result_.unreachable;
    std::vector<RoadId> route(plan.route.begin(),
                              plan.route.begin() + static_cast<std::ptrdiff_t>(plan.committed - 1));
    for (const VertexId vertex : decision.route) route.push_back(graph.road(vertex));
    // SUMO may end a vehicle at once that is told to drive from its road back to the same road (13628).
    if (decision.change && route.front() == route.back()) decision.change = false;
    if (decision.change && !follows(traveller.vehicle)) {
      decision.change = false;
      ++result_.ignored;
    }
    if (decision.change) {
      decision.change = simulation_.assign(traveller.vehicle, route);
      ++(decision.change ? result_.reroutes : result_.refused);
      if (decision.change && strategy_.looks_ahead()) fleet_.on_route(traveller.vehicle, route);
    }
    predict(traveller, decision);
    if (options_.log_decisions) log(traveller, decision);
  }

  /// Drawn for each vehicle and moment: the same in every run with this seed, whatever the threads.
  [[nodiscard]] bool follows(VehicleId vehicle) const {
    if (options_.compliance >= 1) return true;
    return unit_hash(fmt::format("{}#{}#{}", demand_.vehicles[vehicle].id, simulation_.now(),
                                 options_.seed)) < options_.compliance;
  }

  /// When it arrives on the way that was chosen.
  [[nodiscard]] Millis predicted_arrival(const Traveller& traveller, const Decision& decision) const {
    return add_saturating(arrival(traveller, decision, simulation_.now(), decision.cost()),
                          decision.at_the_end + decision.later);
  }

  void predict(const Traveller& traveller, const Decision& decision) {
    if (decision.change) ledger_.changed_way(traveller.vehicle);
    const auto& way = decision.change ? decision.route : traveller.route;
    const Millis measured = route_cost(traffic_[traveller.vehicle_class], way);
    ledger_.predicted(traveller.vehicle, simulation_.now(), predicted_arrival(traveller, decision),
                      arrival(traveller, {}, simulation_.now(), measured));
  }

  void log(const Traveller& traveller, const Decision& decision) {
    const RoadGraph& graph = traffic_.graph(traveller.vehicle_class);
    LoggedDecision entry{.time = simulation_.now(),
                         .vehicle = traveller.vehicle,
                         .old_route = {},
                         .new_route = {},
                         .old_cost = decision.old_cost,
                         .new_cost = decision.new_cost,
                         .predicted_arrival = predicted_arrival(traveller, decision)};
    for (const VertexId vertex : traveller.route) entry.old_route.push_back(graph.road(vertex));
    if (decision.change) {
      for (const VertexId vertex : decision.route) entry.new_route.push_back(graph.road(vertex));
    }
    result_.log.push_back(std::move(entry));
  }

  Simulation& simulation_;
  const Network& network_;
  const Demand& demand_;
  Strategy& strategy_;
  const ControlOptions& options_;
  RunResult& result_;
  Agenda agenda_;
  Millis sample_interval_;
  MeasuredTimes measured_;
  Conditions conditions_;
  Fleet fleet_;  ///< kept for those who look ahead
  SignalWatch signals_;
  PredictionLedger ledger_;
  IdVector<VehicleId, Question> last_questions_;
  LiveTraffic traffic_;
  Millis next_sample_ = 0;
  Millis next_adaptation_ = 0;
  std::uint32_t news_ = 0;  ///< how often there was something new to decide by
  std::vector<VehicleId> due_;
  std::vector<VehicleId> between_turns_;  ///< asked because of the road that they got on
  std::vector<Traveller> travellers_;
  std::vector<Plan> plans_;  ///< of the travellers
  std::vector<Decision> decisions_;
};

}  // namespace

RunResult control(Simulation& simulation, const Network& network, const Demand& demand, Strategy* strategy,
                  const ControlOptions& options, const std::function<void(const Simulation&)>& progress,
                  const std::atomic<bool>& stop) {
  RunResult result;
  result.begin = simulation.now();
  result.arrival.assign(demand.vehicles.size(), infinity);
  double mark = cpu_seconds();
  const auto lap = [&](double& account) {
    const double now = cpu_seconds();
    account += now - mark;
    mark = now;
  };
  std::optional<Controller> controller;
  if (strategy != nullptr) controller.emplace(simulation, network, demand, *strategy, options, result);
  Millis last_arrival = simulation.now();
  while (true) {
    if (controller) controller->update();
    lap(result.router_cpu_s);
    if (stop) {
      result.reason = StopReason::interrupted;
      break;
    }
    if (simulation.now() >= simulation.end()) {
      result.reason = StopReason::end_reached;
      break;
    }
    if (simulation.end() == infinity && simulation.is_empty()) {
      result.reason = StopReason::emptied;
      break;
    }
    if (simulation.end() == infinity && simulation.now() - last_arrival >= options.stall) {
      result.reason = StopReason::stalled;
      break;
    }
    simulation.step();
    for (const VehicleId vehicle : simulation.events().arrived) result.arrival[vehicle] = simulation.now();
    if (!simulation.events().arrived.empty() || simulation.running_count() == 0)
      last_arrival = simulation.now();
    lap(result.simulation_cpu_s);
    if (progress) progress(simulation);
  }
  result.end = simulation.now();
  return result;
}

}  // namespace thalweg
