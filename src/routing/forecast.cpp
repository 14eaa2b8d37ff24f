// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>
#include <optional>

#include "core/parallel.hpp"
#include "routing/foresight.hpp"
#include "routing/list.hpp"
#include "routing/potentials.hpp"
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
        signal_phases_(options.signal_phases),
        order_cache_(options.order_cache),
        workers_(std::max<std::size_t>(1, options.threads)) {}

  [[nodiscard]] bool looks_ahead() const override { return true; }
  [[nodiscard]] Look next_look(Millis now) const override {
    return foresight_ && !foresight_->is_round_due(now) ? Look::lanes : Look::positions;
  }

  void watch(const TrafficState& state) override {
    if (!foresight_)
      foresight_.emplace(state, memory_, ForecastOptions{.tolls = manners_.toll > 0},
                         ServerOptions{.signal_phases = signal_phases_});
    if (!foresight_->watch(state)) return;
    rule_.caution = foresight_->hindsight().caution();
    for (auto& seen : classes_) seen.is_fresh = false;
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
        ClassView& view = classes_[traveller.vehicle_class];
        decide_one(graph, view, traveller, workers_[worker], decisions[first + i]);
        foretell_end(graph, *view.costs, traveller.route.back(), decisions[first + i]);
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
  /// A way as it will be driven.
  struct Drive {
    Millis arrival = 0;  ///< on the last road; infinity: never
    Millis owed = 0;
  };

  void prepare(const ClassTraffic& traffic, std::size_t vehicle_class) {
    ClassView& view = classes_[vehicle_class];
    if (view.is_fresh) return;
    view.is_fresh = true;
    if (!view.costs) {
      view.costs.emplace(foresight_->network(), *traffic.graph);
      view.potentials.emplace(traffic.graph->turns(), order_cache_);
      // Places that are given back make roads faster than they were foretold.
      if (manners_.books) view.potentials->refresh(view.costs->free_flow(), workers_.size());
    }
    view.costs->refresh(foresight_->expected(), foresight_->forecast_at());
    if (!manners_.books) view.potentials->refresh(view.costs->least(), workers_.size());
  }

  /// Its share of what it costs the others that it enters the road at this time.
  [[nodiscard]] Millis toll(const RoadGraph& graph, const TimedCosts& costs, VertexId vertex,
                            Millis time) const {
    if (manners_.toll <= 0) return 0;
    const RoadId road = graph.road(vertex);
    const QueueTable& table = foresight_->expected().forecast;
    const std::size_t bin = table.bin_at(reaches_end(graph, costs, vertex, time));
    return from_seconds(manners_.toll * static_cast<double>(table.toll(road, bin)));
  }

  /// When the traveller has made a turn, having entered the road before it at a time. One that waits for its
  /// insertion does so in the line of its first turn: it may get on the road later than at `begin`.
  [[nodiscard]] auto arrivals(const RoadGraph& graph, const TimedCosts& costs, const Traveller& traveller,
                              Millis begin) const {
    const VertexId front = traveller.route.front();
    const bool has_lines = !traveller.departed && foresight_->has_lines(graph.road(front));
    return [this, &graph, &costs, &traveller, begin, front, has_lines](ArcId turn, Millis time) {
      const bool gets_on = has_lines && time == begin && graph.turns().ends(turn).tail == front;
      return costs.arrive(turn, gets_on ? insertion(graph, traveller, graph.turns().ends(turn).head) : time);
    };
  }
  [[nodiscard]] Millis insertion(const RoadGraph& graph, const Traveller& traveller, VertexId second) const {
    const Millis wanted = std::max<Millis>(0, traveller.until_route);
    return foresight_->now() + foresight_->insertion(traveller.vehicle, wanted,
                                                     graph.road(traveller.route.front()), graph.road(second));
  }

  /// Calls `enters(i, time)` for each road of the route but the last.
  template <class Enters>
  Drive drive(const RoadGraph& graph, const TimedCosts& costs, const Traveller& traveller,
              std::span<const VertexId> route, Millis begin, const Enters& enters) const {
    const auto arrive = arrivals(graph, costs, traveller, begin);
    Drive result;
    Millis time = begin;
    for (std::size_t i = 0; i + 1 < route.size() && time < infinity; ++i) {
      enters(i, time);
      result.owed += toll(graph, costs, route[i], time);
      Millis next = infinity;
      for (const Arc& arc : graph.turns().out(route[i])) {
        if (arc.end == route[i + 1]) next = std::min(next, arrive(arc.id, time));
      }
      time = next;
    }
    result.arrival = never(begin, time) ? infinity : time;
    return result;
  }

  /// The way leads through a closed road.
  static bool never(Millis begin, Millis arrival) { return arrival - begin >= TimedCosts::closed / 2; }

  /// When it enters the first road of its route, at the earliest where it waits for its insertion. One that
  /// is on it is as one that entered so much earlier as leaves when it does.
  [[nodiscard]] Millis start(const RoadGraph& graph, const TimedCosts& costs,
                             const Traveller& traveller) const {
    if (!traveller.departed) return earliest_insertion(graph, traveller);
    const VertexId front = traveller.route.front();
    if (const auto leaving = foresight_->leaving(traveller.vehicle)) {
      if (leaving->road == graph.road(front)) return start_in_queue(graph, costs, front, leaving->at);
      const Servers& servers = foresight_->expected().servers;
      const MovementId turn = servers.find(leaving->road, graph.road(front));
      if (turn.valid()) return leaving->at + from_seconds(servers[turn].through);
    }
    return foresight_->now() + std::max<Millis>(0, traveller.until_route) -
           static_cast<Millis>(traveller.driven * static_cast<double>(crossing_of(graph, costs, front)));
  }
  [[nodiscard]] Millis earliest_insertion(const RoadGraph& graph, const Traveller& traveller) const {
    Millis earliest =
        insertion(graph, traveller, traveller.route[std::min<std::size_t>(1, traveller.route.size() - 1)]);
    if (!foresight_->has_lines(graph.road(traveller.route.front()))) return earliest;
    for (const Arc& turn : graph.turns().out(traveller.route.front()))
      earliest = std::min(earliest, insertion(graph, traveller, turn.end));
    return earliest;
  }
  /// The forecast says when it leaves, by its place in the queue. What the costs know of that road's end
  /// beside the forecast (residuals, bookings) counts by the share of the road that is still before it.
  [[nodiscard]] Millis start_in_queue(const RoadGraph& graph, const TimedCosts& costs, VertexId front,
                                      Millis leaves) const {
    const Expectation expected = foresight_->expected();
    const RoadId road = graph.road(front);
    const double crossing = expected.level.pace() * expected.servers.free_flow(road);
    const double foretold =
        crossing + expected.forecast.wait_after(road, crossing);  // who enters now leaves then
    const Millis whole = costs.to_end(front);
    const double left = to_seconds(leaves - foresight_->now());
    const double more = std::min(1.0, left / std::max(1.0, foretold)) * (to_seconds(whole) - foretold);
    return foresight_->now() + from_seconds(std::max(0.0, left + more)) - whole;
  }
  /// In s from the forecast on, of one that enters the road at this time.
  [[nodiscard]] double reaches_end(const RoadGraph& graph, const TimedCosts& costs, VertexId road,
                                   Millis time) const {
    return to_seconds(time + crossing_of(graph, costs, road) - foresight_->forecast_at());
  }
  [[nodiscard]] Millis crossing_of(const RoadGraph& graph, const TimedCosts& costs, VertexId road) const {
    return foresight_->driven(costs.road_time(graph.road(road)));
  }

  void decide_one(const RoadGraph& graph, ClassView& view, const Traveller& traveller, Worker& worker,
                  Decision& decision) const {
    const Digraph& turns = graph.turns();
    const TimedCosts& costs = *view.costs;
    const Millis begin = start(graph, costs, traveller);
    const Millis last = crossing_of(graph, costs, traveller.route.back());
    const Drive old = drive(graph, costs, traveller, traveller.route, begin, [](std::size_t, Millis) {});
    const auto arrive = arrivals(graph, costs, traveller, begin);
    decision.entered = begin;
    decision.old_cost = old.arrival >= infinity ? infinity : old.arrival - begin + last;
    decision.new_cost = decision.old_cost;
    // Only ways that the rule would take are searched for, with what is owed as a cost like time, and among
    // them those that are not later for the vehicle itself: mostly there is none, which is seen soon.
    TimedLimits limits;
    if (old.arrival < infinity) {
      const Millis with_tolls = decision.old_cost + old.owed;
      limits = {.below = old.arrival + old.owed - rule_.threshold(traveller, with_tolls),
                .latest = old.arrival};
    }
    decision.route.push_back(traveller.route.front());
    Drive best{.arrival = begin};
    VertexId at = traveller.route.front();
    for (const VertexId waypoint : traveller.waypoints) {
      view.potentials->start(worker.left, waypoint);
      const auto found = timed_search(
          turns, at, best.arrival, best.owed, waypoint, limits, arrive,
          [&](VertexId road, Millis time) { return toll(graph, costs, road, time); },
          [&](VertexId v) { return view.potentials->left(worker.left, v); }, worker.search);
      if (!found || never(begin, found->arrival)) {
        decision.route.clear();  // none at all, or none that the rule would take
        if (old.arrival < infinity) decision.route = traveller.route;
        return;
      }
      for (const ArcId arc : found->arcs) decision.route.push_back(turns.ends(arc).head);
      best = {.arrival = found->arrival, .owed = found->owed};
      at = waypoint;
    }
    decision.new_cost = best.arrival - begin + last;  // what it owes is not part of the time that is foretold
    decision.change = decision.route != traveller.route;
  }

  /// The costs have the last road as it is driven by one that nobody is in the way of.
  void foretell_end(const RoadGraph& graph, const TimedCosts& costs, VertexId last,
                    Decision& decision) const {
    if (decision.cost() >= infinity) return;
    const Millis alone = crossing_of(graph, costs, last);
    const Millis entry = *decision.entered + decision.cost() - alone;
    const double ahead = std::max(0.0, to_seconds(entry - foresight_->forecast_at()));
    const RoadId road = graph.road(last);
    const double delay = std::max(0.0, foresight_->expected().delay(road, ahead));
    decision.at_the_end =
        costs.crossing(road) - alone + from_seconds(foresight_->share_of_last_delay(road) * delay);
  }

  /// Moves the places of those who changed their ways.
  void book(std::span<const ClassTraffic> traffic, std::span<const Traveller> due,
            std::span<const Decision> decisions) {
    for (std::size_t i = 0; i < due.size(); ++i) {
      if (!decisions[i].change) continue;
      const RoadGraph& graph = *traffic[due[i].vehicle_class].graph;
      const TimedCosts& costs = *classes_[due[i].vehicle_class].costs;
      const Millis entered = *decisions[i].entered;
      take_places(graph, costs, due[i], due[i].route, entered, -1);
      take_places(graph, costs, due[i], decisions[i].route, entered, +1);
    }
    for (const RoadId road : foresight_->bookings().take_changed()) {
      for (ClassView& view : classes_) {
        if (view.is_fresh) view.costs->refresh(foresight_->expected(), road);
      }
    }
  }
  void take_places(const RoadGraph& graph, const TimedCosts& costs, const Traveller& traveller,
                   std::span<const VertexId> route, Millis entered, double count) {
    drive(graph, costs, traveller, route, entered, [&](std::size_t i, Millis time) {
      foresight_->bookings().book(graph.road(route[i]), reaches_end(graph, costs, route[i], time), count);
    });
  }

  ChoiceRule rule_;
  Manners manners_;
  const Memory* memory_;
  bool signal_phases_;
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
