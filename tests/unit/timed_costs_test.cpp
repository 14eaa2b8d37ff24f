// SPDX-License-Identifier: Apache-2.0
#include "traffic/timed_costs.hpp"

#include <gtest/gtest.h>

#include "support/queueing.hpp"

namespace thalweg::testing {
namespace {

//     A---B---C---D      30 s each, 2 s a vehicle
class TimedCostsTest : public ::testing::Test {
 protected:
  [[nodiscard]] ArcId turn(const char* from) const {
    return graph.turns().out(vertex(net, graph, from)).front().id;
  }

  Network net = ascii_network("A---B---C---D");
  RoadGraph graph{net, VehicleClass::passenger};
  Servers servers{net};
};

TEST_F(TimedCostsTest, AreFreeFlowWhereNobodyIs) {
  Driven driven(net, 1);
  const Discharge discharge(net, servers, driven.demand);
  QueueForecast forecast(net, servers, discharge);
  Residuals residuals(net);
  TimedCosts costs(net, graph);
  forecast.run(driven.fleet, 0);
  costs.refresh(forecast, residuals, Conditions(net), 0);
  for (const Millis time : {Millis{0}, Millis{7}, Millis{999'000}, Millis{10'000'000}})
    EXPECT_EQ(costs.arrive(turn("AB"), time), time + 30'000);
}

// Thirty stand at the end of AB for a minute. Who enters AB now reaches them in 30 s, waits for what is left
// of the minute, and who enters later waits less, but never passes anybody.
TEST_F(TimedCostsTest, FollowTheQueueAndNobodyPasses) {
  Driven driven(net, 30);
  std::vector<Driven::At> places;
  for (std::size_t i = 0; i < 30; ++i) {
    driven.load(i, "ABCD");
    places.push_back({.vehicle = i, .road = "AB", .metres = 299});
  }
  driven.look(places);
  const Discharge discharge(net, servers, driven.demand);
  QueueForecast forecast(net, servers, discharge, {.repeated = 0});
  Residuals residuals(net);
  TimedCosts costs(net, graph);
  forecast.run(driven.fleet, 0);
  costs.refresh(forecast, residuals, Conditions(net), 0);
  EXPECT_NEAR(to_seconds(costs.arrive(turn("AB"), 0)), 60, 4);
  EXPECT_EQ(costs.arrive(turn("AB"), 200'000), 230'000);
  Millis last = 0;
  for (Millis time = 0; time < 400'000; time += 500) {
    const Millis arrival = costs.arrive(turn("AB"), time);
    EXPECT_GE(arrival, last) << time;
    EXPECT_GE(arrival, time + 30'000);
    last = arrival;
  }
}

// A road that is measured at 100 s where the model says 30 s costs more now, and less and less of it later.
TEST_F(TimedCostsTest, WhatWasMeasuredMovesThemAndFades) {
  Driven driven(net, 1);
  const Discharge discharge(net, servers, driven.demand);
  QueueForecast forecast(net, servers, discharge);
  MeasuredTimes measured(net, 180'000, 1'000);
  for (int second = 0; second < 180; ++second) {  // ten vehicles at 3 m/s
    const std::vector<Observation> seen(10, {.road = road(net, "AB"), .speed = 3});
    measured.sample(seen);
  }
  EXPECT_NEAR(measured.passage(road(net, "AB")).vehicle_seconds, 1800, 1);
  EXPECT_NEAR(measured.passage(road(net, "AB")).traversals, 1800 * 3 / 300.0, 0.1);
  Residuals residuals(net);
  forecast.run(driven.fleet, 0);
  residuals.refresh(servers, forecast, measured);
  EXPECT_NEAR(residuals[road(net, "AB")], 70, 9) << "eight traversals' worth is left to the model";
  TimedCosts costs(net, graph);
  costs.refresh(forecast, residuals, Conditions(net), 0);
  const double now = to_seconds(costs.arrive(turn("AB"), 0)) - 30;
  const double later = to_seconds(costs.arrive(turn("AB"), 900'000) - 900'000) - 30;
  EXPECT_NEAR(now, residuals[road(net, "AB")], 0.1);
  EXPECT_NEAR(later, now * 0.3679, 0.5);
}

// BC is closed for ten seconds, and slow from then on.
TEST_F(TimedCostsTest, KnowWhatIsClosedAndWhatIsSlow) {
  Driven driven(net, 1);
  const Discharge discharge(net, servers, driven.demand);
  QueueForecast forecast(net, servers, discharge);
  const Residuals residuals(net);
  TimedCosts costs(net, graph);
  forecast.run(driven.fleet, 0);
  const auto lane = [&](const char* id) { return net.roads[road(net, id)].first_lane; };
  Conditions conditions(net, {{.lane = lane("BC"), .end = 10'000, .permissions = Permissions::none()},
                              {.lane = lane("BC"), .begin = 10'000, .speed = 2}});
  conditions.advance(0);
  costs.refresh(forecast, residuals, conditions, 0);
  EXPECT_GE(costs.arrive(turn("AB"), 0), TimedCosts::closed);
  EXPECT_EQ(costs.arrive(turn("BC"), 0), 30'000) << "who is there may leave";
  conditions.advance(10'000);
  costs.refresh(forecast, residuals, conditions, 10'000);
  EXPECT_EQ(costs.arrive(turn("AB"), 10'000), 40'000);
  EXPECT_EQ(costs.arrive(turn("BC"), 10'000), 160'000) << "300 m at 2 m/s";
}

}  // namespace
}  // namespace thalweg::testing
