// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>
#include <optional>
#include <unordered_map>

#include "core/parallel.hpp"
#include "routing/hindsight.hpp"
#include "routing/list.hpp"
#include "search/dijkstra.hpp"
#include "search/timed_search.hpp"
#include "traffic/discharge.hpp"
#include "traffic/queue_forecast.hpp"
#include "traffic/residuals.hpp"
#include "traffic/servers.hpp"
#include "traffic/timed_costs.hpp"

namespace thalweg {
namespace {

/// The free-flow time to a destination from everywhere, for those that were asked for; the potentials of the
/// searches. The oldest are forgotten when they take too much room.
class Potentials {
 public:
  explicit Potentials(std::size_t bytes) : bytes_(bytes) {}

  using Tree = std::vector<Millis>;  // by vertex

  /// Before a batch; what is asked for from here on stays until the next.
  void begin(std::size_t vertices) {
    if (trees_.size() * vertices * sizeof(Millis) > bytes_) trees_.clear();
  }
  const Tree& to(const Digraph& turns, const std::vector<Millis>& costs, VertexId destination) {
    auto& entry = trees_[destination];
    if (entry) return *entry;
    dijkstra<Direction::backward>(
        turns, std::span(&destination, 1), [&](ArcId arc) { return costs[arc.value]; }, tree_, scratch_);
    entry = std::make_unique<Tree>(tree_.label.begin(), tree_.label.end());
    return *entry;
  }

 private:
  std::size_t bytes_;
  std::unordered_map<VertexId, std::unique_ptr<Tree>> trees_;
  thalweg::Tree tree_;
  DijkstraScratch scratch_;
};

/// Routes by the times that a queue forecast expects, made anew every `round`.
class ForecastStrategy : public Strategy {
 public:
  explicit ForecastStrategy(const StrategyOptions& options)
      : rule_(options.rule), scratch_(std::max<std::size_t>(1, options.threads)) {}

  [[nodiscard]] bool looks_ahead() const override { return true; }

  void watch(const TrafficState& state) override {
    now_ = state.now;
    if (!model_) model_.emplace(state);
    for (const SignalId signal : state.changed_signals)
      model_->servers.set_programme(signal, state.programmes[signal]);
    for (const RoadId road : state.conditions.roads())
      model_->servers.set_free_flow(road, state.conditions.crossing(road));
    model_->discharge.observe(state.fleet, state.now);
    model_->forecast.observe(state.fleet, state.now);
    model_->hindsight.observe(state.fleet, state.now);
    if (state.now < next_round_ && state.conditions.version() == conditions_version_) return;
    conditions_version_ = state.conditions.version();
    next_round_ = state.now + round_;
    model_->forecast.run(state.fleet, state.now);
    model_->residuals.refresh(model_->servers, model_->forecast, state.measured);
    round_time_ = state.now;
    rule_.caution = model_->hindsight.caution();
    for (auto& seen : classes_) seen.is_fresh = false;
  }

  void decide(std::span<const ClassTraffic> traffic, std::span<const Traveller> due,
              std::vector<Decision>& decisions) override {
    decisions.assign(due.size(), {});
    classes_.resize(traffic.size());
    for (std::size_t i = 0; i < traffic.size(); ++i) {
      if (classes_[i].potentials) classes_[i].potentials->begin(traffic[i].graph->turns().vertex_count());
    }
    for (const Traveller& traveller : due) prepare(traffic[traveller.vehicle_class], traveller);
    parallel_for(due.size(), scratch_.size(), [&](std::size_t i, std::size_t worker) {
      decide_one(*traffic[due[i].vehicle_class].graph, classes_[due[i].vehicle_class], due[i],
                 scratch_[worker], decisions[i]);
    });
  }

  void applied(std::span<const Traveller> due, std::span<const Decision> decisions) override {
    for (std::size_t i = 0; i < due.size(); ++i) {
      model_->hindsight.decided(due[i].vehicle, now_, due[i].arrival(now_, decisions[i].old_cost),
                                due[i].arrival(now_, decisions[i].new_cost), decisions[i].change);
    }
  }

 private:
  struct Model {
    explicit Model(const TrafficState& state)
        : network(state.network),
          conditions(state.conditions),
          servers(state.network),
          discharge(state.network, servers, state.demand),
          forecast(state.network, servers, discharge),
          residuals(state.network),
          hindsight(state.demand.vehicles.size()) {}
    const Network& network;
    const Conditions& conditions;
    Servers servers;
    Discharge discharge;
    QueueForecast forecast;
    Residuals residuals;
    Hindsight hindsight;
  };
  struct ClassView {
    std::optional<TimedCosts> costs{};
    std::unique_ptr<Potentials> potentials{};
    bool is_fresh = false;
  };

  void prepare(const ClassTraffic& traffic, const Traveller& traveller) {
    ClassView& view = classes_[traveller.vehicle_class];
    if (!view.costs) {
      view.costs.emplace(model_->network, *traffic.graph);
      view.potentials = std::make_unique<Potentials>(std::size_t{256} << 20);
    }
    if (!view.is_fresh)
      view.costs->refresh(model_->forecast, model_->residuals, model_->conditions, round_time_);
    view.is_fresh = true;
    for (const VertexId waypoint : traveller.waypoints)
      static_cast<void>(view.potentials->to(traffic.graph->turns(), view.costs->free_flow(), waypoint));
  }

  /// When it enters the road at the end of `route`.
  Millis drive(const Digraph& turns, const TimedCosts& costs, std::span<const VertexId> route,
               Millis time) const {
    for (std::size_t i = 0; i + 1 < route.size() && time < infinity; ++i) {
      Millis next = infinity;
      for (const Arc& arc : turns.out(route[i])) {
        if (arc.end == route[i + 1]) next = std::min(next, costs.arrive(arc.id, time));
      }
      time = next;
    }
    return never(time) ? infinity : time;
  }

  /// The way leads through a closed road.
  [[nodiscard]] bool never(Millis arrival) const { return arrival - now_ >= TimedCosts::closed / 2; }

  void decide_one(const RoadGraph& graph, ClassView& view, const Traveller& traveller, TimedScratch& scratch,
                  Decision& decision) const {
    const Digraph& turns = graph.turns();
    const TimedCosts& costs = *view.costs;
    // One that has driven a part of its road is as one that entered it so much earlier.
    const Millis driven = static_cast<Millis>(
        traveller.driven * static_cast<double>(costs.road_time(graph.road(traveller.route.front()))));
    const Millis start = now_ + std::max<Millis>(0, traveller.until_route) - driven;
    decision.entered = start;
    const Millis last = costs.road_time(graph.road(traveller.route.back()));
    const Millis old_arrival = drive(turns, costs, traveller.route, start);
    decision.old_cost = old_arrival >= infinity ? infinity : old_arrival - start + last;
    decision.new_cost = decision.old_cost;
    // Only ways that the rule would take are searched for: mostly there is none, which is seen soon.
    const Millis bound =
        old_arrival >= infinity ? infinity : old_arrival - rule_.threshold(traveller, decision.old_cost);
    decision.route.push_back(traveller.route.front());
    Millis time = start;
    VertexId at = traveller.route.front();
    for (const VertexId waypoint : traveller.waypoints) {
      const auto& left = view.potentials->to(turns, costs.free_flow(), waypoint);
      const auto found = timed_search(
          turns, at, time, waypoint, bound, [&](ArcId arc, Millis t) { return costs.arrive(arc, t); },
          [&](VertexId v) { return left[v.value]; }, scratch);
      if (!found || never(found->arrival)) {
        decision.route.clear();  // none at all, or none that the rule would take
        if (old_arrival < infinity) decision.route = traveller.route;
        return;
      }
      for (const ArcId arc : found->arcs) decision.route.push_back(turns.ends(arc).head);
      time = found->arrival;
      at = waypoint;
    }
    decision.new_cost = time - start + last;
    decision.change =
        decision.route != traveller.route && rule_.prefers(traveller, decision.old_cost, decision.new_cost);
  }

  ChoiceRule rule_;
  Millis round_ = 15'000;
  Millis next_round_ = 0;
  std::uint32_t conditions_version_ = 0;
  Millis round_time_ = 0;
  Millis now_ = 0;
  std::optional<Model> model_;
  std::vector<ClassView> classes_;
  std::vector<TimedScratch> scratch_;
};

}  // namespace

std::unique_ptr<Strategy> make_forecast(const StrategyOptions& options) {
  return std::make_unique<ForecastStrategy>(options);
}

}  // namespace thalweg
