// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cch/order_cache.hpp"
#include "core/time.hpp"
#include "demand/demand.hpp"
#include "graph/road_graph.hpp"
#include "traffic/conditions.hpp"
#include "traffic/fleet.hpp"
#include "traffic/memory.hpp"

namespace thalweg {

/// The traffic as one vehicle class sees it now: f(t, I) of the paper with the value of now.
struct ClassTraffic {
  const RoadGraph* graph = nullptr;
  RoadTimes free_flow;
  RoadTimes road_times;            ///< live
  std::vector<Millis> turn_costs;  ///< by ArcId, live
};

/// A vehicle whose turn it is to reconsider. Roads are vertices of its class's graph.
struct Traveller {
  VehicleId vehicle;
  std::size_t vehicle_class = 0;    ///< index of its ClassTraffic
  std::vector<VertexId> route;      ///< its present way, from the first road whose next turn is still free
  std::vector<VertexId> waypoints;  ///< roads it must pass in this order: stops, `via`; last its destination
  Millis until_route = 0;           ///< from now until it enters route.front()
  double driven = 0;                ///< share of route.front() that lies behind it
  double patience = 0;              ///< in [0, 1), by a hash of its name; above: it has reasons to stay
  bool departed = true;
};

/// What was decided for a traveller. Costs run from entering route.front() to the end of the last road.
struct Decision {
  bool change = false;
  std::vector<VertexId> route{};  ///< the best way found, from the same first road; empty: there is none
  Millis old_cost = 0;
  Millis new_cost = 0;  ///< of `route`
  /// Of the way that was chosen.
  [[nodiscard]] Millis cost() const { return change ? new_cost : old_cost; }
  /// When it entered route.front(), where the strategy knows better than Traveller::until_route.
  std::optional<Millis> entered{};
  /// The delay expected on its last road, behind the others there. The same on every way, so that it has no
  /// part in the costs that are compared.
  Millis at_the_end = 0;
  /// By how much those before it came later than was foretold for them.
  Millis later = 0;
};

/// When a traveller arrives that decides at `now` for a way of this cost.
inline Millis arrival(const Traveller& traveller, const Decision& decision, Millis now, Millis cost) {
  return add_saturating(decision.entered.value_or(now + traveller.until_route), cost);
}

/// When a traveller gives up its way for a better one: the gain must exceed
/// (relative + spread * patience) of the cost left plus `absolute`; before departure, when turning costs
/// nothing, `relative` is left out; `caution` comes on top for everybody. Thresholds that differ between
/// vehicles keep everybody from turning at the same news.
struct ChoiceRule {
  double relative = 0.05;
  double spread = 0.15;
  Millis absolute = 3'000;
  double caution = 0;  ///< learned by the strategy (Hindsight)

  [[nodiscard]] bool prefers(const Traveller& traveller, Millis old_cost, Millis new_cost) const;
  /// What a way must gain more than, against one of a finite cost, to be preferred.
  [[nodiscard]] Millis threshold(const Traveller& traveller, Millis old_cost) const;
};

/// A signal that follows the traffic, and what it shows.
struct ShownSignal {
  SignalId signal;
  ShownPhase phase;
};

/// What the control loop knows of the traffic after a look at it.
struct TrafficState {
  Millis now = 0;
  const Network& network;
  const Demand& demand;
  const Fleet& fleet;
  const MeasuredTimes& measured;
  std::span<const Observation> observations;  ///< of now
  const Conditions& conditions;
  const IdVector<SignalId, SignalProgramme>& programmes;
  std::span<const SignalId> changed_signals;  ///< those whose programme is new
  std::span<const ShownSignal> following;     ///< what those show that follow the traffic
};

/// Decides for those who are due at a step, as one batch: each vehicle once a period, in its own phase.
class Strategy {
 public:
  virtual ~Strategy() = default;
  /// Whether `watch` wants to be called: keeping the fleet costs time.
  [[nodiscard]] virtual bool looks_ahead() const { return false; }
  /// How closely it wants to look at the traffic now.
  [[nodiscard]] virtual Look next_look(Millis /*now*/) const {
    return looks_ahead() ? Look::positions : Look::roads;
  }
  /// After every look at the traffic, before those who are due decide.
  virtual void watch(const TrafficState& /*state*/) {}
  /// Whether one that gets on this road decides at once, beside its turn.
  [[nodiscard]] virtual bool asks_on(RoadId /*road*/) const { return false; }
  /// decisions[i] belongs to due[i]. The result does not depend on the number of threads.
  virtual void decide(std::span<const ClassTraffic> traffic, std::span<const Traveller> due,
                      std::vector<Decision>& decisions) = 0;
  /// At the end of a run: what it has lived goes into the memory.
  virtual void remember(Memory& /*memory*/) {}
  /// After `decide`: what came of it. `change` is false where SUMO refused a route or a driver did not
  /// follow.
  virtual void applied(std::span<const Traveller> /*due*/, std::span<const Decision> /*decisions*/) {}
};

struct StrategyOptions {
  ChoiceRule rule{};
  /// Share of the delay that it costs the others (TollTable) that a vehicle counts as its own: `forecast`,
  /// `memory`.
  double toll = 0.4;
  /// Whether those who look ahead know what signals show at which time, or their mean waits only.
  bool signal_phases = true;
  /// Whether these assume that the last minutes' departures come again, beyond those that SUMO has loaded.
  bool assumed_departures = true;
  std::size_t threads = 1;
  OrderCache order_cache{};        ///< of the hierarchy; nowhere by default
  const Memory* memory = nullptr;  ///< of the days before, for `memory`; outlives the strategy
};

/// The strategies there are, each with the sentence that `--help` shows.
struct StrategyEntry {
  std::string_view name;
  std::string_view summary;
  std::unique_ptr<Strategy> (*make)(const StrategyOptions&);
  bool needs_simulation = false;  ///< it decides by what it has watched: nothing for `thalweg route`
};
std::span<const StrategyEntry> strategies();

/// InputError with the nearest name when there is none of this name.
std::unique_ptr<Strategy> make_strategy(std::string_view name, const StrategyOptions& options);

/// What the route costs now, its last road included; infinity when two of its roads are not joined.
Millis route_cost(const ClassTraffic& traffic, std::span<const VertexId> route);

}  // namespace thalweg
