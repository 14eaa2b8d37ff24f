// SPDX-License-Identifier: Apache-2.0
#include "routing/strategy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "routing/list.hpp"
#include "support/class_traffic.hpp"
#include "support/input_error.hpp"

namespace thalweg::testing {
namespace {

constexpr std::uint64_t cities = 100;
constexpr ChoiceRule any_gain{.relative = 0, .spread = 0, .absolute = 0};
/// Those that find the way of least cost; the others may be above it.
constexpr std::array<std::string_view, 4> exact_strategies{"evolved", "cch", "hierarchy", "dijkstra"};

/// Those that decide by the live times alone, and the hierarchy without the trees that `cch` prefers for
/// cities as small as these.
std::vector<StrategyEntry> strategies_under_test() {
  std::vector<StrategyEntry> entries(strategies().begin(), strategies().end());
  std::erase_if(entries, [](const StrategyEntry& entry) { return entry.needs_simulation; });
  entries.push_back({.name = "hierarchy", .summary = "", .make = &make_hierarchy});
  return entries;
}

std::unique_ptr<Strategy> make_by_name(std::string_view name, const StrategyOptions& options) {
  return name == "hierarchy" ? make_hierarchy(options) : make_strategy(name, options);
}

bool is_exact(std::string_view name) {
  return std::find(exact_strategies.begin(), exact_strategies.end(), name) != exact_strategies.end();
}

/// The least cost of a way by nothing but its definition; shares no code with the searches it judges. From
/// entering `from` to the end of `to`.
Millis least_cost(const ClassTraffic& traffic, VertexId from, VertexId to) {
  const Digraph& turns = traffic.graph->turns();
  std::vector<Millis> least(turns.vertex_count(), infinity);
  least[from.value] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < turns.arc_count(); ++i) {
      const auto [tail, head] = turns.ends(ArcId{i});
      const Millis candidate = add_saturating(least[tail.value], traffic.turn_costs[i]);
      if (candidate >= least[head.value]) continue;
      least[head.value] = candidate;
      changed = true;
    }
  }
  return add_saturating(least[to.value], traffic.road_times[traffic.graph->road(to)]);
}

/// The same through the way points.
Millis least_cost(const ClassTraffic& traffic, const Traveller& traveller) {
  Millis cost = 0;
  VertexId at = traveller.route.front();
  for (const VertexId waypoint : traveller.waypoints) {
    // Each leg but the last ends where it enters its way point.
    const Millis leg = least_cost(traffic, at, waypoint);
    const Millis last_road = traffic.road_times[traffic.graph->road(waypoint)];
    if (leg >= infinity || last_road >= infinity) return infinity;
    cost += leg - last_road;
    at = waypoint;
  }
  return cost + traffic.road_times[traffic.graph->road(at)];
}

/// Random travellers; every second has way points between, some stand where they want to go, and the present
/// way of some is broken: its roads are drawn at random.
std::vector<Traveller> random_travellers(const SeenTraffic& city, Dice& dice) {
  const std::size_t roads = city.graph().turns().vertex_count();
  std::vector<Traveller> due(roads == 0 ? 0 : 20);
  for (std::size_t i = 0; i < due.size(); ++i) {
    Traveller& traveller = due[i];
    traveller.vehicle = VehicleId{i};
    traveller.patience = static_cast<double>(dice.roll(100)) / 100;
    traveller.route.emplace_back(dice.roll(roads));
    for (std::size_t steps = dice.roll(30); steps > 0; --steps) {
      const auto next = city.graph().turns().out(traveller.route.back());
      if (next.empty()) break;
      traveller.route.push_back(next[dice.roll(next.size())].end);
    }
    if (i % 5 == 4) traveller.route.emplace_back(dice.roll(roads));
    if (i % 2 == 1) {
      const std::size_t middle = dice.roll(traveller.route.size());
      if (middle > 0 && middle + 1 < traveller.route.size())
        traveller.waypoints.push_back(traveller.route[middle]);
    }
    if (traveller.waypoints.empty() || traveller.waypoints.back() != traveller.route.back())
      traveller.waypoints.push_back(traveller.route.back());
  }
  return due;
}

/// Live times above free flow, some roads closed.
void add_random_traffic(SeenTraffic& city, Dice& dice) {
  for (Millis& time : city.traffic.road_times) {
    if (dice.roll(3) == 0) time *= static_cast<Millis>(1 + dice.roll(6));
    if (dice.roll(40) == 0) time = infinity;
  }
  city.refresh();
}

std::vector<Decision> decide(std::string_view strategy, const SeenTraffic& city,
                             const std::vector<Traveller>& due,
                             const StrategyOptions& options = {.rule = any_gain, .threads = 1}) {
  std::vector<Decision> decisions(3);  // what is left of another batch must not show
  make_by_name(strategy, options)->decide({&city.traffic, 1}, due, decisions);
  return decisions;
}

class StrategyContract : public ::testing::TestWithParam<StrategyEntry> {
 protected:
  [[nodiscard]] static std::string_view name() { return GetParam().name; }

  /// Calls `check(city, due, decisions)` for every random city.
  template <class Check>
  void for_every_city(Check check) {
    for (std::uint64_t seed = 0; seed < cities; ++seed) {
      SCOPED_TRACE(::testing::Message() << "city " << seed);
      SeenTraffic city(random_network(seed));
      Dice dice(seed);
      add_random_traffic(city, dice);
      const auto due = random_travellers(city, dice);
      const auto decisions = decide(name(), city, due);
      ASSERT_EQ(decisions.size(), due.size());
      check(city, due, decisions);
      if (HasFatalFailure() || HasNonfatalFailure()) return;
    }
  }

  /// The decision for one traveller on `route`, by way of `waypoints`.
  static Decision decide_one(const SeenTraffic& city, std::vector<VertexId> route,
                             std::vector<VertexId> waypoints,
                             const StrategyOptions& options = {.rule = any_gain, .threads = 1},
                             double patience = 0) {
    Traveller traveller;
    traveller.route = std::move(route);
    traveller.waypoints = std::move(waypoints);
    traveller.patience = patience;
    return decide(name(), city, {traveller}, options).front();
  }
};

TEST_P(StrategyContract, RoutesAreLegalAndPassTheWayPointsInOrder) {
  std::size_t found = 0;
  std::size_t changed = 0;
  for_every_city([&](const SeenTraffic& city, const auto& due, const auto& decisions) {
    for (std::size_t i = 0; i < due.size(); ++i) {
      const auto& route = decisions[i].route;
      if (route.empty()) {
        EXPECT_FALSE(decisions[i].change);
        EXPECT_EQ(decisions[i].new_cost, infinity);
        continue;
      }
      ++found;
      changed += decisions[i].change ? 1U : 0U;
      EXPECT_EQ(route.front(), due[i].route.front());
      EXPECT_EQ(route.back(), due[i].waypoints.back());
      auto position = route.begin();
      for (const VertexId waypoint : due[i].waypoints) {
        position = std::find(position, route.end(), waypoint);
        EXPECT_NE(position, route.end()) << "traveller " << i << " misses a way point";
        if (position == route.end()) break;
      }
      for (std::size_t k = 0; k + 1 < route.size(); ++k) {
        const auto turns = city.graph().turns().out(route[k]);
        EXPECT_TRUE(std::any_of(turns.begin(), turns.end(),
                                [&](const Arc& turn) { return turn.end == route[k + 1]; }))
            << "traveller " << i << ": no turn from road " << k << " of its route";
      }
    }
  });
  EXPECT_GT(found, 500U);
  EXPECT_GT(changed, 100U);
}

TEST_P(StrategyContract, CostsAreThoseOfTheRoutes) {
  for_every_city([&](const SeenTraffic& city, const auto& due, const auto& decisions) {
    for (std::size_t i = 0; i < due.size(); ++i) {
      EXPECT_EQ(decisions[i].old_cost, route_cost(city.traffic, due[i].route)) << "traveller " << i;
      if (decisions[i].route.empty()) continue;
      EXPECT_EQ(decisions[i].new_cost, route_cost(city.traffic, decisions[i].route)) << "traveller " << i;
    }
  });
}

TEST_P(StrategyContract, NeverBelowTheLeastCostAndExactWhereItClaimsToBe) {
  std::size_t above = 0;
  std::size_t unreachable = 0;
  for_every_city([&](const SeenTraffic& city, const auto& due, const auto& decisions) {
    for (std::size_t i = 0; i < due.size(); ++i) {
      const Millis least = least_cost(city.traffic, due[i]);
      EXPECT_GE(decisions[i].new_cost, least) << "traveller " << i;
      above += decisions[i].new_cost > least ? 1U : 0U;
      unreachable += least >= infinity ? 1U : 0U;
    }
  });
  EXPECT_GT(unreachable, 20U);
  if (is_exact(name())) {
    EXPECT_EQ(above, 0U);
  } else {
    EXPECT_GT(above, 20U) << "the cities test nothing";
  }
}

TEST_P(StrategyContract, ChangesForAGainOnly) {
  for_every_city([&](const SeenTraffic&, const auto& due, const auto& decisions) {
    for (std::size_t i = 0; i < due.size(); ++i) {
      const Decision& decision = decisions[i];
      EXPECT_EQ(decision.change, decision.new_cost < decision.old_cost) << "traveller " << i;
      EXPECT_FALSE(decision.change && decision.route == due[i].route) << "traveller " << i;
    }
  });
}

TEST_P(StrategyContract, DecisionsDoNotDependOnThreadsNorOnTheRestOfTheBatch) {
  for_every_city([&](const SeenTraffic& city, const auto& due, const auto& decisions) {
    for (const std::size_t threads : {2U, 4U}) {
      const auto parallel = decide(name(), city, due, {.rule = any_gain, .threads = threads});
      ASSERT_EQ(parallel.size(), due.size());
      for (std::size_t i = 0; i < due.size(); ++i) {
        EXPECT_EQ(parallel[i].change, decisions[i].change) << threads << " threads, traveller " << i;
        EXPECT_EQ(parallel[i].route, decisions[i].route) << threads << " threads, traveller " << i;
        EXPECT_EQ(parallel[i].new_cost, decisions[i].new_cost) << threads << " threads, traveller " << i;
      }
    }
    for (std::size_t i = 0; i < due.size(); i += 7) {
      const auto alone = decide(name(), city, {due[i]});
      EXPECT_EQ(alone.front().new_cost, decisions[i].new_cost) << "traveller " << i;
    }
  });
}

TEST_P(StrategyContract, IsReusable) {
  const auto strategy = make_by_name(name(), {.rule = any_gain, .threads = 1});
  for (const std::uint64_t seed : {3U, 4U, 3U}) {
    SeenTraffic city(random_network(seed));
    Dice dice(seed);
    const auto due = random_travellers(city, dice);
    std::vector<Decision> decisions;
    strategy->decide({&city.traffic, 1}, due, decisions);
    const auto fresh = decide(name(), city, due);
    ASSERT_EQ(decisions.size(), due.size());
    for (std::size_t i = 0; i < due.size(); ++i) EXPECT_EQ(decisions[i].route, fresh[i].route);
  }
}

TEST_P(StrategyContract, AnEmptyBatchIsNoDecision) {
  const SeenTraffic city(ascii_network("A-B-C"));
  EXPECT_TRUE(decide(name(), city, {}).empty());
}

TEST_P(StrategyContract, NoThreadsIsOneThread) {
  const SeenTraffic city(ascii_network("A-B-C"));
  const auto decision =
      decide_one(city, city.route("ABC"), {city.at("BC")}, {.rule = any_gain, .threads = 0});
  EXPECT_EQ(city.text(decision.route), "AB BC");
}

//     S-A-B-T      AB is jammed: the way round by C and D is better
//       | |
//       C-D
constexpr const char* way_round = "S-A-B-T\n  | |\n  C-D";

TEST_P(StrategyContract, TakesTheWayRoundAJamUnlessItHasTooManyTurns) {
  SeenTraffic city(ascii_network(way_round));
  city.set_time("AB", 100'000);
  const Decision decision = decide_one(city, city.route("SABT"), {city.at("BT")});
  EXPECT_EQ(decision.old_cost, 120'000);
  if (is_exact(name())) {
    EXPECT_TRUE(decision.change);
    EXPECT_EQ(city.text(decision.route), "SA AC CD DB BT");
    EXPECT_EQ(decision.new_cost, 50'000);
  } else {  // the hybrid's ways have the fewest turns
    EXPECT_FALSE(decision.change);
    EXPECT_EQ(city.text(decision.route), "SA AB BT");
    EXPECT_EQ(decision.new_cost, 120'000);
  }
}

//     S-A-B
//       | |
//       C-D-T      by B or by C: four roads each
TEST_P(StrategyContract, OfEquallyManyTurnsTheFastestIsTaken) {
  SeenTraffic city(ascii_network("S-A-B\n  | |\n  C-D-T"));
  city.set_time("BD", 30'000);
  const Decision by_c = decide_one(city, city.route("SABDT"), {city.at("DT")});
  EXPECT_TRUE(by_c.change);
  EXPECT_EQ(city.text(by_c.route), "SA AC CD DT");
  city.set_time("AC", 31'000);
  const Decision by_b = decide_one(city, city.route("SACDT"), {city.at("DT")});
  EXPECT_TRUE(by_b.change);
  EXPECT_EQ(city.text(by_b.route), "SA AB BD DT");
}

TEST_P(StrategyContract, OriginIsDestination) {
  const SeenTraffic city(ascii_network(way_round));
  const Decision here = decide_one(city, city.route("AB"), {city.at("AB")});
  EXPECT_FALSE(here.change);
  EXPECT_EQ(here.old_cost, 10'000);
  EXPECT_EQ(here.new_cost, 10'000);
  EXPECT_EQ(city.text(here.route), "AB");
  // Told to go round once more, it may stay.
  const Decision round = decide_one(city, city.route("ABDCAB"), {city.at("AB")});
  EXPECT_TRUE(round.change);
  EXPECT_EQ(city.text(round.route), "AB");
  EXPECT_EQ(round.old_cost, 50'000);
}

//     A->B->C      nothing leads back
TEST_P(StrategyContract, UnreachableIsNoChange) {
  const SeenTraffic city(ascii_network("A->B->C"));
  const Decision decision = decide_one(city, city.route("BC"), {city.at("AB")});
  EXPECT_FALSE(decision.change);
  EXPECT_TRUE(decision.route.empty());
  EXPECT_EQ(decision.new_cost, infinity);
  const Decision by_way_point =
      decide_one(city, city.route("ABC"), {city.at("BC"), city.at("AB"), city.at("BC")});
  EXPECT_FALSE(by_way_point.change) << "one leg that cannot be driven spoils the way";
  EXPECT_TRUE(by_way_point.route.empty());
}

TEST_P(StrategyContract, AClosedDestinationIsUnreachable) {
  const SeenTraffic city(ascii_network("A-B-C", {.roads = {{"BC", {.speed = 0}}}}));
  const Decision decision = decide_one(city, city.route("ABC"), {city.at("BC")});
  EXPECT_FALSE(decision.change);
  EXPECT_EQ(decision.new_cost, infinity);
}

TEST_P(StrategyContract, ABrokenWayIsReplacedWhateverTheRule) {
  const SeenTraffic city(ascii_network(way_round, {.forbidden_turns = "SAB"}));
  const StrategyOptions stubborn{.rule = {.relative = 0.9, .spread = 0.9, .absolute = 1'000'000}};
  const Decision decision = decide_one(city, city.route("SABT"), {city.at("BT")}, stubborn, 0.99);
  EXPECT_EQ(decision.old_cost, infinity);
  EXPECT_TRUE(decision.change);
  EXPECT_EQ(city.text(decision.route), "SA AC CD DB BT");
}

TEST_P(StrategyContract, WayPointsAreHard) {
  const SeenTraffic city(ascii_network(way_round));
  const Decision decision = decide_one(city, city.route("SACDBT"), {city.at("CD"), city.at("BT")});
  EXPECT_FALSE(decision.change) << "SA AB BT is faster, but does not pass CD";
  EXPECT_EQ(city.text(decision.route), "SA AC CD DB BT");
  // The same road twice in a row of stops is there but once.
  const Decision twice =
      decide_one(city, city.route("SACDBT"), {city.at("CD"), city.at("CD"), city.at("BT")});
  EXPECT_EQ(city.text(twice.route), "SA AC CD DB BT");
}

TEST_P(StrategyContract, AClassKeepsToItsRoads) {
  const SeenTraffic city(ascii_network(way_round, {.roads = {{"AB", {.permissions = "allow=\"bus\""}}}}));
  const Decision decision = decide_one(city, city.route("SACDBT"), {city.at("BT")});
  EXPECT_FALSE(decision.change);
  EXPECT_EQ(city.text(decision.route), "SA AC CD DB BT");
}

// Cars and buses in one batch: each is decided on its own graph.
TEST_P(StrategyContract, ClassesOfABatchDoNotMix) {
  const char* const map = way_round;
  const AsciiOptions options{.roads = {{"AB", {.permissions = "allow=\"bus\""}}}};
  const SeenTraffic cars(ascii_network(map, options));
  const SeenTraffic buses(ascii_network(map, options), VehicleClass::bus);
  const ClassTraffic traffic[] = {cars.traffic, buses.traffic};
  std::vector<Traveller> due(4);
  for (std::size_t i = 0; i < due.size(); ++i) {
    due[i].vehicle_class = i % 2;
    due[i].route = cars.route("SACDBT");
    due[i].waypoints = {cars.at("BT")};
  }
  std::vector<Decision> decisions;
  make_by_name(name(), {.rule = any_gain, .threads = 1})->decide(traffic, due, decisions);
  for (std::size_t i = 0; i < due.size(); ++i) {
    EXPECT_EQ(cars.text(decisions[i].route), i % 2 == 0 ? "SA AC CD DB BT" : "SA AB BT") << i;
    EXPECT_EQ(decisions[i].change, i % 2 == 1) << i;
  }
}

// The way by C and D costs 50 s, that by AB 30 s: a gain of 20 s, two fifths.
TEST_P(StrategyContract, TheRuleIsRespected) {
  const SeenTraffic city(ascii_network(way_round));
  const auto changes = [&](const ChoiceRule& rule, double patience) {
    return decide_one(city, city.route("SACDBT"), {city.at("BT")}, {.rule = rule, .threads = 1}, patience)
        .change;
  };
  EXPECT_TRUE(changes(any_gain, 0));
  EXPECT_TRUE(changes({.relative = 0.39, .spread = 0, .absolute = 0}, 0));
  EXPECT_FALSE(changes({.relative = 0.4, .spread = 0, .absolute = 0}, 0)) << "the gain must exceed it";
  EXPECT_TRUE(changes({.relative = 0, .spread = 0, .absolute = 19'999}, 0));
  EXPECT_FALSE(changes({.relative = 0, .spread = 0, .absolute = 20'000}, 0));
  EXPECT_TRUE(changes({.relative = 0, .spread = 0.5, .absolute = 0}, 0.7));
  EXPECT_FALSE(changes({.relative = 0, .spread = 0.5, .absolute = 0}, 0.9));
  EXPECT_TRUE(changes({.relative = 0.1, .spread = 0.5, .absolute = 4'000}, 0.3));
  EXPECT_FALSE(changes({.relative = 0.1, .spread = 0.5, .absolute = 8'000}, 0.3)) << "they add up";
}

INSTANTIATE_TEST_SUITE_P(EveryStrategy, StrategyContract, ::testing::ValuesIn(strategies_under_test()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(Strategies, TheExactOnesAreThere) {
  for (const auto name : exact_strategies) EXPECT_NE(make_by_name(name, {}), nullptr);
}

TEST(Strategies, AnUnknownNameIsAnErrorWithTheNearest) {
  const std::string message = input_error([] { make_strategy("evolve", {}); });
  EXPECT_EQ(message,
            "there is no strategy 'evolve' (did you mean 'evolved'?); there are: hybrid, evolved, forecast, "
            "booking, marginal, memory, cch, dijkstra");
}

TEST(ChoiceRule, BeforeDepartureTheRelativeGainIsLeftOut) {
  const ChoiceRule rule{.relative = 0.4, .spread = 0, .absolute = 0};
  Traveller traveller;
  traveller.departed = true;
  EXPECT_FALSE(rule.prefers(traveller, 50'000, 30'000));
  traveller.departed = false;
  EXPECT_TRUE(rule.prefers(traveller, 50'000, 30'000));
  EXPECT_FALSE(rule.prefers(traveller, 50'000, 50'000)) << "no gain";
  EXPECT_FALSE(rule.prefers(traveller, infinity, infinity));
}

TEST(RouteCost, IsTheTurnsAndTheLastRoad) {
  SeenTraffic city(ascii_network("A--B-C", {.junction_metres = 20}));
  EXPECT_EQ(route_cost(city.traffic, city.route("ABC")), 20'000 + 2'000 + 10'000);
  EXPECT_EQ(route_cost(city.traffic, city.route("BC")), 10'000);
  EXPECT_EQ(route_cost(city.traffic, std::vector<VertexId>{}), infinity);
  EXPECT_EQ(route_cost(city.traffic, std::vector{city.at("AB"), city.at("AB")}), infinity) << "no such turn";
}

}  // namespace
}  // namespace thalweg::testing
