// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "simulation/control.hpp"
#include "support/fake_simulation.hpp"
#include "support/watched.hpp"

namespace thalweg::testing {
namespace {

//     Q           A vehicle a second comes from P and Q together; the ends of AB and of AC let one pass in 2
//     s. |           All 60 mean to go by B, where a queue is to be expected. CD is 100 m, or longer, at
//   P-A-B            10 m/s.
//     | |
//     C-D-T
struct Setting {
  std::string_view strategy = "forecast";
  double cd_metres = 100;
  double toll = 0;
  Millis least_gain = 1'000;
  std::size_t threads = 1;
};

/// How many of them go by C after everybody has decided once.
std::size_t by_c(const Setting& setting) {
  const Network net =
      ascii_network("  Q\n  |\nP-A-B\n  | |\n  C-D-T", {.roads = {{"CD", {.length = setting.cd_metres}}}});
  std::vector<FakeVehicle> vehicles;
  for (std::size_t i = 0; i < 60; ++i) {
    vehicles.push_back({.id = fmt::format("v{}", i),
                        .depart = static_cast<Millis>(i) * 1000,
                        .route = way(net, i % 2 == 0 ? "PABDT" : "QABDT")});
  }
  FakeSimulation simulation(net, vehicles, {.end = 1'000});
  const auto own =
      make_strategy(setting.strategy, {.rule = {.relative = 0, .spread = 0, .absolute = setting.least_gain},
                                       .toll = setting.toll,
                                       .threads = setting.threads});
  const std::atomic<bool> stop = false;
  control(simulation, net, simulation.demand(), own.get(), {.period = 0}, {}, stop);
  const RoadId cd = road(net, "CD");
  std::size_t count = 0;
  for (const Assignment& assignment : simulation.assignments)
    count += static_cast<std::size_t>(std::count(assignment.route.begin(), assignment.route.end(), cd));
  return count;
}

TEST(Forecast, WhoDecidesAloneGoesWhereEverybodyGoes) { EXPECT_GT(by_c({}), 45U); }

TEST(Booking, WhoSeesWhatOthersBookedSpreads) {
  const std::size_t count = by_c({.strategy = "booking"});
  EXPECT_GT(count, 5U);
  EXPECT_LT(count, 30U) << "until the others have no queue to leave";
}

TEST(Booking, DoesNotDependOnThreads) {
  EXPECT_EQ(by_c({.strategy = "booking"}), by_c({.strategy = "booking", .threads = 2}));
}

// The first in the queue lose next to nothing there, but hold up all that come behind them.
TEST(Toll, WhoHoldsUpManyLeavesTheQueueForALittleGain) {
  const std::size_t selfish = by_c({.least_gain = 15'000});
  EXPECT_GT(selfish, 5U);
  EXPECT_GT(by_c({.toll = 1, .least_gain = 15'000}), selfish + 10);
}

// Nobody waits for 30 s at the end of AB, so by C all would be later, though it were better for all together.
TEST(Toll, NobodyIsSentOnAWayThatIsLaterForItself) {
  EXPECT_EQ(by_c({.cd_metres = 400, .toll = 10, .least_gain = 0}), 0U);
}

TEST(Toll, IsWholeInMarginal) {
  EXPECT_EQ(by_c({.strategy = "marginal", .toll = 0, .least_gain = 15'000}),
            by_c({.toll = 1, .least_gain = 15'000}));
}

/// What it decides for one that enters the first of these roads, by the junctions of its way.
Decision decision_of(Strategy& strategy, const Network& net, std::size_t vehicle,
                     std::string_view junctions) {
  const RoadGraph graph(net, VehicleClass::passenger);
  Traveller due;
  due.vehicle = VehicleId{vehicle};
  for (const RoadId road : way(net, junctions)) due.route.push_back(graph.vertex(road));
  due.waypoints = {due.route.back()};
  const std::vector<Millis> costs(graph.turns().arc_count(), 30'000);
  const std::vector<ClassTraffic> classes{
      {.graph = &graph, .free_flow = {}, .road_times = {}, .turn_costs = costs}};
  std::vector<Decision> decisions;
  strategy.decide(classes, std::vector{due}, decisions);
  return decisions[0];
}

//     A---B---C---D      30 s each, junctions 2 s. Forty stand at the end of BC for 80 s, or nobody; one
//                        that enters AB ends at C.
Decision ends_at_c(std::size_t queue, double limit = 10) {
  Network net = ascii_network("A---B---C---D");
  const LaneId bc = net.roads[road(net, "BC")].first_lane;
  Watched traffic(std::move(net), 41, {{.lane = bc, .speed = limit}});
  std::vector<Driven::At> places;
  for (std::size_t i = 0; i < queue; ++i) {
    traffic.driven.load(i, "BCD");
    places.push_back({.vehicle = i, .road = "BC", .metres = 299});
  }
  traffic.driven.load(40, "ABC");
  places.push_back({.vehicle = 40, .road = "AB"});
  const auto strategy = make_strategy("forecast", {});
  strategy->watch(traffic.look(places, 0));
  return decision_of(*strategy, traffic.network, 40, "ABC");
}

// Who is at its end in 62 s, between 60 and 80, would wait there for 10 s to drive on; half of that if it
// ends there.
TEST(Forecast, WhoEndsOnARoadIsInItsQueueForAShare) {
  const Decision decision = ends_at_c(40);
  EXPECT_NEAR(to_seconds(decision.old_cost), 62, 0.1);
  EXPECT_NEAR(to_seconds(decision.at_the_end), 10 / 2.0, 0.1);
}

TEST(Forecast, WhoEndsOnARoadThatASignSlowsIsSlowThere) {
  EXPECT_NEAR(to_seconds(ends_at_c(0).at_the_end), 0, 0.1);
  EXPECT_NEAR(to_seconds(ends_at_c(0, 5).at_the_end), 30, 0.1);
}

//     E          Every second a vehicle has set out for D, from EB and from BC in turn, for ten
//     |          minutes. All of them are gone. One enters AB, for D as well.
// A---B---C---D
Millis cost_to_d(bool assumed_departures) {
  Watched traffic(ascii_network("    E\n    |\n    |\nA---B---C---D"), 601);
  const auto strategy = make_strategy("forecast", {.assumed_departures = assumed_departures});
  for (std::size_t i = 0; i < 600; ++i) {
    const Millis depart = 1000 * static_cast<Millis>(i);
    traffic.driven.load(i, i % 2 == 0 ? "EBCD" : "BCD", depart);
    strategy->watch(traffic.look({}, depart));
    traffic.driven.fleet.on_departed(VehicleId{i});
    traffic.driven.fleet.on_arrived(VehicleId{i});
  }
  traffic.driven.load(600, "ABCD");
  strategy->watch(traffic.look({{.vehicle = 600, .road = "AB"}}, 600'000));
  return decision_of(*strategy, traffic.network, 600, "ABCD").old_cost;
}

TEST(Forecast, ExpectsThatOthersSetOutAsBefore) { EXPECT_GT(cost_to_d(true), cost_to_d(false) + 10'000); }

}  // namespace
}  // namespace thalweg::testing
