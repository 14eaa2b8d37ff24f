// SPDX-License-Identifier: Apache-2.0
#include "traffic/memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "core/hash.hpp"
#include "routing/list.hpp"
#include "traffic/lived_times.hpp"

namespace thalweg {
namespace {

/// Share of the vehicles that look for a better way on a day, others each day. When all do, everybody's
/// answer of today spoils what was learned yesterday; this is how day-to-day models come to rest (Cascetta
/// 1989).
constexpr double reconsidering = 0.3;
/// Added to the patience of the others: they leave their way only when it has become far worse than another.
constexpr double loyalty = 5;

/// Whether one can drive `route`, from road to road of the graph, by way of `waypoints`.
bool leads(const Digraph& turns, std::span<const VertexId> route, std::span<const VertexId> waypoints) {
  auto waypoint = waypoints.begin();
  for (std::size_t i = 0; i < route.size(); ++i) {
    if (!route[i].valid()) return false;
    if (waypoint != waypoints.end() && route[i] == *waypoint) ++waypoint;
    if (i + 1 == route.size()) break;
    const auto out = turns.out(route[i]);
    if (std::none_of(out.begin(), out.end(), [&](const Arc& arc) { return arc.end == route[i + 1]; }))
      return false;
  }
  return waypoint == waypoints.end() && !route.empty() && route.back() == waypoints.back();
}

/// The paper's crew: the forecast, with what the days before have taught. A vehicle that sets out takes the
/// way that is remembered of it as its own. Some reconsider it today by the forecast, the others stay unless
/// it is blocked or far worse than another; and the forecast expects those who set out on the day remembered.
class MemoryStrategy : public Strategy {
 public:
  explicit MemoryStrategy(const StrategyOptions& options)
      : memory_(options.memory), forecast_(make_forecast(options)) {}

  [[nodiscard]] bool looks_ahead() const override { return true; }
  [[nodiscard]] Look next_look(Millis now) const override { return forecast_->next_look(now); }
  [[nodiscard]] bool asks_on(RoadId road) const override { return forecast_->asks_on(road); }

  void watch(const TrafficState& state) override {
    if (!lived_) begin_day(state);
    lived_->look(state.observations, state.now);
    for (const VehicleId vehicle : state.fleet.present()) {
      const FleetVehicle& seen = state.fleet[vehicle];
      // Where it is turned to on its way is left to the next day. With the routes as driven in the end, which
      // today's jams have shaped, twin heavy takes 3 % longer.
      if (seen.state == FleetVehicle::State::waiting || trips_[vehicle].route.empty())
        trips_[vehicle].route = seen.route;
      last_seen_[vehicle] = state.now;
    }
    forecast_->watch(state);
  }

  void decide(std::span<const ClassTraffic> traffic, std::span<const Traveller> due,
              std::vector<Decision>& decisions) override {
    travellers_.assign(due.begin(), due.end());
    for (Traveller& traveller : travellers_) {
      take_remembered(*traffic[traveller.vehicle_class].graph, traveller);
      if (is_loyal_[traveller.vehicle]) traveller.patience += loyalty;
    }
    forecast_->decide(traffic, travellers_, decisions);
    for (std::size_t i = 0; i < due.size(); ++i) {
      if (travellers_[i].route != due[i].route) decide_by_memory(due[i], travellers_[i], decisions[i]);
    }
  }

  void applied(std::span<const Traveller> /*due*/, std::span<const Decision> decisions) override {
    forecast_->applied(travellers_, decisions);
  }

  void remember(Memory& memory) override {
    if (!lived_) return;
    std::vector<RememberedTrip> trips;
    double commute = 0;
    for (std::size_t i = 0; i < trips_.size(); ++i) {
      RememberedTrip& trip = trips_[VehicleId{i}];
      if (trip.route.empty()) continue;
      commute += to_seconds(std::max<Millis>(0, last_seen_[VehicleId{i}] - trip.depart));
      trips.push_back(std::move(trip));
    }
    commute /= static_cast<double>(std::max<std::size_t>(1, trips.size()));
    memory.learn(lived_->take(), std::move(trips), commute);
  }

 private:
  /// What was decided for one on its remembered way, as a decision for the way that SUMO has it on.
  static void decide_by_memory(const Traveller& due, const Traveller& remembered, Decision& decision) {
    if (!decision.change) {
      decision.route = remembered.route;
      decision.new_cost = decision.old_cost;
    } else if (decision.route == due.route) {
      decision.old_cost = decision.new_cost;
    }
    decision.change = decision.route != due.route;
  }

  void begin_day(const TrafficState& state) {
    lived_.emplace(state.network, memory_ != nullptr ? memory_->bin : Memory{}.bin);
    last_seen_.assign(state.demand.vehicles.size(), 0);
    is_loyal_.assign(state.demand.vehicles.size(), 0);
    trips_.assign(state.demand.vehicles.size(), {});
    yesterday_.assign(state.demand.vehicles.size(), nullptr);
    std::unordered_map<std::string_view, const RememberedTrip*> known;
    if (memory_ != nullptr) {
      for (const RememberedTrip& trip : memory_->trips) known.emplace(trip.vehicle, &trip);
    }
    for (std::size_t i = 0; i < trips_.size(); ++i) {
      const DemandVehicle& vehicle = state.demand.vehicles[VehicleId{i}];
      trips_[VehicleId{i}] = {.vehicle = vehicle.id, .depart = vehicle.depart.value_or(0)};
      const auto found = known.find(vehicle.id);
      if (found != known.end() && !vehicle.fixed) yesterday_[VehicleId{i}] = found->second;
    }
  }

  /// Once, before it departs.
  void take_remembered(const RoadGraph& graph, Traveller& traveller) {
    const RememberedTrip* trip = std::exchange(yesterday_[traveller.vehicle], nullptr);
    if (trip == nullptr || traveller.departed) return;
    std::vector<VertexId> route;
    for (const RoadId road : trip->route) route.push_back(graph.vertex(road));
    if (!leads(graph.turns(), route, traveller.waypoints) || route.front() != traveller.route.front()) return;
    traveller.route = std::move(route);
    is_loyal_[traveller.vehicle] =
        unit_hash(fmt::format("{} {}", trip->vehicle, memory_->days)) >= reconsidering ? 1 : 0;
  }

  const Memory* memory_;
  std::unique_ptr<Strategy> forecast_;
  std::optional<LivedTimes> lived_;
  IdVector<VehicleId, RememberedTrip> trips_;             ///< of today
  IdVector<VehicleId, const RememberedTrip*> yesterday_;  ///< ways that are still to be taken up
  IdVector<VehicleId, Millis> last_seen_;
  IdVector<VehicleId, char> is_loyal_;
  std::vector<Traveller> travellers_;
};

}  // namespace

std::unique_ptr<Strategy> make_memory(const StrategyOptions& options) {
  return std::make_unique<MemoryStrategy>(options);
}

}  // namespace thalweg
