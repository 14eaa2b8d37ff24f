// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>
#include <optional>

#include "core/parallel.hpp"
#include "routing/foresight.hpp"
#include "routing/list.hpp"
#include "routing/potentials.hpp"
#include "routing/timed_ways.hpp"
#include "search/timed_search.hpp"

namespace thalweg {
namespace {

/// What a strategy of this kind does beside looking ahead.
struct Manners {
  double toll = 0;     ///< share of what a vehicle costs the others that counts as a cost of its own
  bool books = false;  ///< who decides sees what those before it in the same round have decided; tolls do not
};

/// Routes by the times that a queue forecast expects, and by a share of the delay that a vehicle costs
/// the others: each by its own time alone is Wardrop's equilibrium, with all of that delay it would be
/// the least for all together (Pigou 1920; Merchant, Nemhauser 1978), were the forecast exact. Nobody is sent
/// on a way that is expected to be later for itself.
class ForecastStrategy : public Strategy {
 public:
  ForecastStrategy(const StrategyOptions& options, const Manners& manners)
      : rule_(options.rule),
        manners_(manners),
        memory_(options.memory),
        forecast_{.repeated = options.assumed_departures ? ForecastOptions{}.repeated : 0,
                  .tolls = manners.toll > 0},
        servers_{.signal_phases = options.signal_phases},
        order_cache_(options.order_cache),
        workers_(std::max<std::size_t>(1, options.threads)) {}

  [[nodiscard]] bool looks_ahead() const override { return true; }
  [[nodiscard]] Look next_look(Millis now) const override {
    return foresight_ && !foresight_->is_round_due(now) ? Look::lanes : Look::positions;
  }

  void watch(const TrafficState& state) override {
    if (!foresight_) foresight_.emplace(state, memory_, forecast_, servers_);
    if (!foresight_->watch(state)) return;
    rule_.caution = foresight_->hindsight().caution();
    for (auto& seen : classes_) seen.is_fresh = false;
  }

  [[nodiscard]] bool asks_on(RoadId road) const override {
    return foresight_ && foresight_->what_is_shown_counts(road);
  }

  void decide(std::span<const ClassTraffic> traffic, std::span<const Traveller> due,
              std::vector<Decision>& decisions) override {
    decisions.assign(due.size(), {});
    classes_.resize(traffic.size());
    for (const Traveller& traveller : due) prepare(traffic[traveller.vehicle_class], traveller.vehicle_class);
    // Those of one group do not see each other, whatever the number of threads.
    const std::size_t group = manners_.books ? booking_group : std::max<std::size_t>(1, due.size());
    for (std::size_t first = 0; first < due.size(); first += group) {
      const std::size_t count = std::min(group, due.size() - first);
      parallel_for(count, workers_.size(), [&](std::size_t i, std::size_t worker) {
        const Traveller& traveller = due[first + i];
        const RoadGraph& graph = *traffic[traveller.vehicle_class].graph;
        decide_one(graph, classes_[traveller.vehicle_class], traveller, workers_[worker],
                   decisions[first + i]);
      });
      if (manners_.books)
        book(traffic, due.subspan(first, count), std::span(decisions).subspan(first, count));
    }
  }

  void applied(std::span<const Traveller> due, std::span<const Decision> decisions) override {
    const Millis now = foresight_->now();
    for (std::size_t i = 0; i < due.size(); ++i) {
      const Decision& decision = decisions[i];
      foresight_->hindsight().decided(due[i].vehicle, now, arrival(due[i], decision, now, decision.old_cost),
                                      arrival(due[i], decision, now, decision.new_cost), decision.change);
      if (decision.cost() < infinity)
        foresight_->overrun().predicted(due[i].vehicle, now,
                                        arrival(due[i], decision, now, decision.cost()) + decision.at_the_end,
                                        decision.change);
    }
  }

 private:
  static constexpr std::size_t booking_group = 4;

  struct ClassView {
    std::optional<TimedCosts> costs{};
    std::optional<Potentials> potentials{};
    bool is_fresh = false;
  };
  struct Worker {
    TimedScratch search;
    Potentials::Search left;
  };
  /// What all that is asked about one traveller needs.
  struct Asked {
    const RoadGraph& graph;
    const ClassView& view;
    const Traveller& traveller;
    TimedWays ways;
    Millis begin;  ///< when it enters the first road of its route
  };

  void prepare(const ClassTraffic& traffic, std::size_t vehicle_class) {
    ClassView& view = classes_[vehicle_class];
    if (view.is_fresh) return;
    view.is_fresh = true;
    if (!view.costs) {
      view.costs.emplace(foresight_->network(), *traffic.graph);
      view.potentials.emplace(traffic.graph->turns(), order_cache_);
      // Places that are given back make roads faster than they were foretold.
      if (manners_.books)
        view.potentials->refresh(view.costs->free_flow(), view.costs->free_flow(), workers_.size());
    }
    view.costs->refresh(foresight_->expected(), foresight_->forecast_at());
    if (!manners_.books)
      view.potentials->refresh(view.costs->least(), view.costs->least_in_mean(), workers_.size());
  }

  [[nodiscard]] TimedWays ways(const RoadGraph& graph, const TimedCosts& costs) const {
    return {*foresight_, graph, costs, manners_.toll};
  }

  void decide_one(const RoadGraph& graph, const ClassView& view, const Traveller& traveller, Worker& worker,
                  Decision& decision) const {
    const TimedWays ways = this->ways(graph, *view.costs);
    const Asked asked{graph, view, traveller, ways, ways.start(traveller)};
    const TimedWays::Drive old = ways.drive(traveller, traveller.route, asked.begin);
    const bool is_open = old.arrival < infinity;
    decision.entered = asked.begin;
    decision.old_cost = is_open ? cost(asked, old) : infinity;
    decision.new_cost = decision.old_cost;
    if (is_open) decision.route = traveller.route;
    find_way(asked, old, worker, decision);
    foretell_end(asked, decision);
  }
  [[nodiscard]] static Millis cost(const Asked& asked, const TimedWays::Drive& drive) {
    return drive.arrival - asked.begin + asked.ways.crossing(asked.traveller.route.back());
  }

  /// Only ways that the rule would take are searched for, with what is owed as a cost like time, and among
  /// them those that are not later for the vehicle itself: mostly there is none, which is seen soon.
  void find_way(const Asked& asked, const TimedWays::Drive& old, Worker& worker, Decision& decision) const {
    TimedLimits limits;
    if (old.arrival < infinity) {
      const Millis with_tolls = decision.old_cost + old.owed;
      limits = {.below = old.arrival + old.owed - rule_.threshold(asked.traveller, with_tolls),
                .latest = old.arrival};
    }
    std::vector<VertexId> route{asked.traveller.route.front()};
    TimedWays::Drive way{.arrival = asked.begin};
    for (const VertexId waypoint : asked.traveller.waypoints) {
      way = search(asked, way, waypoint, limits, worker, route);
      if (way.arrival >= infinity) return;  // none at all, or none that the rule would take
    }
    decision.new_cost = cost(asked, way);  // what it owes is not part of the time that is foretold
    decision.change = route != asked.traveller.route;
    decision.route = std::move(route);
  }

  /// From the end of `route` on, which gets what is found; arrival: infinity where nothing is.
  TimedWays::Drive search(const Asked& asked, const TimedWays::Drive& from, VertexId to,
                          const TimedLimits& limits, Worker& worker, std::vector<VertexId>& route) const {
    const Potentials& potentials = *asked.view.potentials;
    potentials.start(worker.left, to);
    const Digraph& turns = asked.graph.turns();
    const Millis known_until = foresight_->forecast_at() + SignalWaits::known_ahead;
    const auto found = timed_search(
        turns, route.back(), from.arrival, from.owed, to, limits,
        asked.ways.arrivals(asked.traveller, asked.begin),
        [&](VertexId road, Millis time) { return asked.ways.toll(road, time); },
        [&](VertexId v, Millis time, Millis most) {
          return potentials.left(worker.left, v, known_until - time, most);
        },
        worker.search);
    if (!found || TimedWays::never(asked.begin, found->arrival)) return {.arrival = infinity};
    for (const ArcId arc : found->arcs) route.push_back(turns.ends(arc).head);
    return {.arrival = found->arrival, .owed = found->owed};
  }

  /// The costs have the last road as it is driven by one that nobody is in the way of.
  void foretell_end(const Asked& asked, Decision& decision) const {
    if (decision.cost() >= infinity) return;
    const VertexId last = asked.traveller.route.back();
    const Millis alone = asked.ways.crossing(last);
    const Millis entry = asked.begin + decision.cost() - alone;
    const double ahead = std::max(0.0, to_seconds(entry - foresight_->forecast_at()));
    const RoadId road = asked.graph.road(last);
    const double delay = std::max(0.0, foresight_->expected().delay(road, ahead));
    decision.at_the_end = asked.view.costs->crossing(road) - alone +
                          from_seconds(foresight_->share_of_last_delay(road) * delay);
    const Millis left = asked.begin + decision.cost() + decision.at_the_end - foresight_->now();
    decision.later = foresight_->overrun().later(std::max<Millis>(0, left));
  }

  /// Moves the places of those who changed their ways.
  void book(std::span<const ClassTraffic> traffic, std::span<const Traveller> due,
            std::span<const Decision> decisions) {
    for (std::size_t i = 0; i < due.size(); ++i) {
      if (!decisions[i].change) continue;
      const RoadGraph& graph = *traffic[due[i].vehicle_class].graph;
      const TimedWays ways = this->ways(graph, *classes_[due[i].vehicle_class].costs);
      const Millis entered = *decisions[i].entered;
      take_places(graph, ways, due[i], due[i].route, entered, -1);
      take_places(graph, ways, due[i], decisions[i].route, entered, +1);
    }
    for (const RoadId road : foresight_->bookings().take_changed()) {
      for (ClassView& view : classes_) {
        if (view.is_fresh) view.costs->refresh(foresight_->expected(), road);
      }
    }
  }
  void take_places(const RoadGraph& graph, const TimedWays& ways, const Traveller& traveller,
                   std::span<const VertexId> route, Millis entered, double count) {
    ways.drive(traveller, route, entered, [&](std::size_t i, Millis time) {
      foresight_->bookings().book(graph.road(route[i]), ways.reaches_end(route[i], time), count);
    });
  }

  ChoiceRule rule_;
  Manners manners_;
  const Memory* memory_;
  ForecastOptions forecast_;
  ServerOptions servers_;
  OrderCache order_cache_;
  std::optional<Foresight> foresight_;
  std::vector<ClassView> classes_;
  std::vector<Worker> workers_;
};

}  // namespace

std::unique_ptr<Strategy> make_forecast(const StrategyOptions& options) {
  return std::make_unique<ForecastStrategy>(options, Manners{.toll = options.toll});
}

std::unique_ptr<Strategy> make_booking(const StrategyOptions& options) {
  return std::make_unique<ForecastStrategy>(options, Manners{.books = true});
}

std::unique_ptr<Strategy> make_marginal(const StrategyOptions& options) {
  return std::make_unique<ForecastStrategy>(options, Manners{.toll = 1});
}

}  // namespace thalweg
