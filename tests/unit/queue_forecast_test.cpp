// SPDX-License-Identifier: Apache-2.0
#include "traffic/queue_forecast.hpp"

#include <gtest/gtest.h>

#include <array>

#include "network/read_network.hpp"
#include "support/queueing.hpp"

namespace thalweg::testing {
namespace {

constexpr ForecastOptions nobody_assumed{.repeated = 0};

//     A-B-C-D      300 m roads at 10 m/s: 30 s; a lane lets one pass in 2 s
class Queues : public ::testing::Test {
 protected:
  /// `count` vehicles stand at the end of AB, bound for D.
  void stand(Driven& driven, std::size_t count) const {
    std::vector<Driven::At> places;
    for (std::size_t i = 0; i < count; ++i) {
      driven.load(i, "ABCD");
      places.push_back({.vehicle = i, .road = "AB", .metres = 300 - 7.5 * static_cast<double>(i)});
    }
    driven.look(places);
  }
  [[nodiscard]] double wait(const QueueForecast& forecast, const char* id, std::size_t bin) const {
    return forecast.table().wait(road(net, id), bin);
  }

  Network net = ascii_network("A---B---C---D");
  Servers servers{net};
};

TEST_F(Queues, NobodyOnTheRoadsIsNoWait) {
  Driven driven(net, 1);
  const Discharge discharge(net, servers, driven.demand);
  QueueForecast forecast(net, servers, discharge, nobody_assumed);
  forecast.run(driven.fleet, Level(net), 0);
  for (std::size_t bin : {0U, 10U, 59U}) EXPECT_EQ(wait(forecast, "AB", bin), 0);
}

// 20 vehicles, 7.5 m each, need 40 s. Who is at the end in the middle of the first bin (10 s) waits for the
// 14 that are there by then; a minute later the queue is gone, and comes to BC stretched, where it is none
// any more.
TEST_F(Queues, AQueueIsServedOneByOne) {
  Driven driven(net, 20);
  stand(driven, 20);
  const Discharge discharge(net, servers, driven.demand);
  QueueForecast forecast(net, servers, discharge, nobody_assumed);
  forecast.run(driven.fleet, Level(net), 0);
  EXPECT_NEAR(wait(forecast, "AB", 0), 18, 1);
  EXPECT_NEAR(wait(forecast, "AB", 1), 10, 3);
  EXPECT_EQ(wait(forecast, "AB", 3), 0);
  EXPECT_LE(wait(forecast, "BC", 2), 2);
  EXPECT_EQ(wait(forecast, "CD", 2), 0) << "a last road has no queue";
}

// BC is 15 m long: two find room on it. Its end lets one pass in 66 s (a signal that is red), so that the
// queue stands back into AB, whose own end would be free.
TEST_F(Queues, AFullRoadHoldsThoseBehindIt) {
  const Network narrow = ascii_network("A---B-C---D", {.roads = {{"BC", {.length = 15}}}});
  Servers slow(narrow);
  Driven driven(narrow, 10);
  Discharge discharge(narrow, slow, driven.demand);
  std::vector<Driven::At> places;
  for (std::size_t i = 0; i < 10; ++i) {
    driven.load(i, "ABCD");
    places.push_back({.vehicle = i, .road = "AB", .metres = 290});
  }
  // Learned: the lane of BC lets pass a quarter of what it should.
  driven.look({});
  QueueForecast free(narrow, slow, discharge, nobody_assumed);
  driven.look(places);
  free.run(driven.fleet, Level(narrow), 0);
  const float unhindered = free.table().wait(road(narrow, "AB"), 0);
  EXPECT_NEAR(unhindered, 12, 4) << "nine in front, 2 s each, less 10 s";

  std::vector<Driven::At> jam{{.vehicle = 0, .road = "BC", .metres = 14},
                              {.vehicle = 1, .road = "BC", .metres = 7}};
  for (std::size_t i = 2; i < 10; ++i) jam.push_back({.vehicle = i, .road = "AB", .metres = 290});
  for (Millis look = 0; look <= 1200; ++look) {  // twenty minutes in which nobody moves
    driven.look(jam);
    discharge.observe(driven.fleet, look * 1000);
  }
  QueueForecast blocked(narrow, slow, discharge, nobody_assumed);
  blocked.run(driven.fleet, Level(narrow), 1'200'000);
  EXPECT_GT(blocked.table().wait(road(narrow, "AB"), 0), 2 * unhindered);
}

//     A ----> M -> N --> O      MN is 15 m long: two find room on it, and its end lets one pass in 5 s. Who
//            ^ |                comes from B gives way to those from A. The way to X is free, but AM has one
//            B X                lane only.
constexpr const char* merge = R"(<net>
  <edge id="AM" from="A" to="M"><lane id="AM_0" index="0" length="300" speed="10"/></edge>
  <edge id="BM" from="B" to="M"><lane id="BM_0" index="0" length="300" speed="10"/></edge>
  <edge id="MN" from="M" to="N"><lane id="MN_0" index="0" length="15" speed="10"/></edge>
  <edge id="MX" from="M" to="X"><lane id="MX_0" index="0" length="300" speed="10"/></edge>
  <edge id="NO" from="N" to="O"><lane id="NO_0" index="0" length="300" speed="10"/></edge>
  <junction id="A" x="0" y="0"/><junction id="B" x="0" y="0"/><junction id="M" x="0" y="0"/>
  <junction id="N" x="0" y="0"/><junction id="O" x="0" y="0"/><junction id="X" x="0" y="0"/>
  <connection from="AM" to="MN" fromLane="0" toLane="0" dir="s" state="M"/>
  <connection from="AM" to="MX" fromLane="0" toLane="0" dir="r" state="M"/>
  <connection from="BM" to="MN" fromLane="0" toLane="0" dir="s" state="m"/>
  <connection from="MN" to="NO" fromLane="0" toLane="0" dir="s" state="s"/>
</net>)";

// Ten stand on either side: those of A go on as places on MN become free, and those of B after them, but for
// the first two, who found room at once. A place is taken as soon as the gap has moved back.
TEST_F(Queues, WhoHasTheRightOfWayGetsTheNextPlace) {
  const Network junction = parse_network(merge);
  const Servers lanes(junction);
  std::vector<std::string> ways(10, "AMNO");
  ways.resize(20, "BMNO");
  const Driven driven = queued(junction, ways);
  const Discharge discharge(junction, lanes, driven.demand);
  QueueForecast forecast(junction, lanes, discharge, nobody_assumed);
  forecast.run(driven.fleet, Level(junction), 0);
  const auto leaves = [&](std::size_t i) { return to_seconds(forecast.leaving(VehicleId{i}).time); };
  for (std::size_t i = 1; i < 10; ++i) EXPECT_GT(leaves(12), leaves(i)) << i;
  EXPECT_NEAR(leaves(9) - leaves(3), 6 * 5, 1) << "one for each that leaves MN";
  EXPECT_NEAR(leaves(19) - leaves(13), 6 * 5, 1);
}

// Of twenty on AM every other one turns to X, or nobody.
TEST_F(Queues, AFullRoadOwesThoseWhoWaitBehindItsOwn) {
  const Network junction = parse_network(merge);
  const Servers lanes(junction);
  const auto toll = [&](const char* every_other) {
    std::vector<std::string> ways(20, "AMNO");
    for (std::size_t i = 1; i < ways.size(); i += 2) ways[i] = every_other;
    const Driven driven = queued(junction, ways);
    const Discharge discharge(junction, lanes, driven.demand);
    QueueForecast forecast(junction, lanes, discharge, {.repeated = 0, .tolls = true});
    forecast.run(driven.fleet, Level(junction), 0);
    return forecast.table().toll(road(junction, "MN"), 0);
  };
  EXPECT_GT(toll("AMX"), toll("AMNO") + 20);
}

// A vehicle every 10 s for 600 s: as many are assumed for the next 600 s, and none when that is switched off.
TEST_F(Queues, DeparturesAreAssumedToGoOn) {
  Driven driven(net, 300);
  const Discharge discharge(net, servers, driven.demand);
  QueueForecast assuming(net, servers, discharge, {});
  QueueForecast knowing(net, servers, discharge, nobody_assumed);
  for (std::size_t i = 0; i < 300; ++i) {
    driven.load(i, "ABCD", static_cast<Millis>(i) * 2000);
    assuming.departures().observe(driven.fleet, static_cast<Millis>(i) * 2000);
    knowing.departures().observe(driven.fleet, static_cast<Millis>(i) * 2000);
    driven.fleet.on_departed(VehicleId{i});
    driven.fleet.on_arrived(VehicleId{i});
  }
  driven.look({});
  assuming.run(driven.fleet, Level(net), 600'000);
  knowing.run(driven.fleet, Level(net), 600'000);
  float assumed = 0;
  for (std::size_t bin = 0; bin < 60; ++bin) {
    assumed = std::max(assumed, assuming.table().wait(road(net, "BC"), bin));
    EXPECT_EQ(knowing.table().wait(road(net, "BC"), bin), 0);
  }
  EXPECT_GT(assumed, 0);
}

// Three want to depart from AB at once, one in 2 s; the fourth in 100 s; the fifth is not loaded.
TEST_F(Queues, WhoWaitsIsInsertedInTurn) {
  Driven driven(net, 5);
  const Discharge discharge(net, servers, driven.demand);
  QueueForecast forecast(net, servers, discharge, nobody_assumed);
  for (std::size_t i = 0; i < 3; ++i) driven.load(i, "ABCD");
  driven.load(3, "ABCD", 100'000);
  forecast.run(driven.fleet, Level(net), 0);
  const std::array<Millis, 5> expected{0, 2'000, 4'000, 100'000, 0};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(forecast.insertion(VehicleId{i}), expected[i]) << i;
}

// Three that want to go straight on stand in one line, and one that turns left beside them.
TEST_F(Queues, WhoHasALaneForHisTurnWaitsForNobodyElse) {
  const Network junction = with_left_lane();
  const Servers lanes(junction);
  Driven driven(junction, 4);
  for (std::size_t i = 0; i < 3; ++i) driven.load(i, i == 1 ? "ABE" : "ABC");
  driven.load(3, "ABD");
  const Discharge discharge(junction, lanes, driven.demand);
  QueueForecast forecast(junction, lanes, discharge, nobody_assumed);
  forecast.run(driven.fleet, Level(junction), 0);
  for (const auto& [vehicle, after] : {std::pair{0, 0}, {1, 1'000}, {2, 2'000}, {3, 0}})
    EXPECT_EQ(forecast.insertion(VehicleId{static_cast<std::size_t>(vehicle)}), after) << vehicle;
}

// Three wanted to depart at 0, 10 and 20 s and still wait at 30 s: who wanted to at 15 s comes before the
// third.
TEST_F(Queues, WhoWouldChangeTheLineComesByItsDeparture) {
  Driven driven(net, 3);
  const Discharge discharge(net, servers, driven.demand);
  QueueForecast forecast(net, servers, discharge, nobody_assumed);
  for (std::size_t i = 0; i < 3; ++i) driven.load(i, "ABCD", static_cast<Millis>(i) * 10'000);
  forecast.run(driven.fleet, Level(net), 30'000);
  const LaneId line = discharge.insertions().line(road(net, "AB"), road(net, "BC"));
  EXPECT_EQ(forecast.insertion(line, -40'000), 0);
  EXPECT_EQ(forecast.insertion(line, -15'000), 4'000);
  EXPECT_EQ(forecast.insertion(line, 0), 6'000);
  EXPECT_EQ(forecast.insertion(line, 50'000), 50'000);
}

// A vehicle in 2 s gets on AB: 600 within the horizon of 1200 s, the others later, each by its place.
TEST_F(Queues, WhoWaitsBeyondTheHorizonKnowsItsPlaceInTheLine) {
  Driven driven(net, 1000);
  const Discharge discharge(net, servers, driven.demand);
  QueueForecast forecast(net, servers, discharge, nobody_assumed);
  for (std::size_t i = 0; i < 1000; ++i) driven.load(i, "ABCD");
  forecast.run(driven.fleet, Level(net), 0);
  EXPECT_EQ(forecast.insertion(VehicleId{500U}), 1'000'000);
  EXPECT_NEAR(to_seconds(forecast.insertion(VehicleId{900U})), 1'800, 5);
}

// Three stand at the end of AB: the first leaves at once, the third 4 s later. The fourth has 200 of the 300
// m to go, the fifth was not seen.
TEST_F(Queues, WhoStandsKnowsItsPlaceInTheQueue) {
  Driven driven(net, 5);
  const Discharge discharge(net, servers, driven.demand);
  QueueForecast forecast(net, servers, discharge, nobody_assumed);
  for (std::size_t i = 0; i < 4; ++i) driven.load(i, "ABCD");
  driven.look({{.vehicle = 0, .road = "AB", .metres = 300},
               {.vehicle = 1, .road = "AB", .metres = 300},
               {.vehicle = 2, .road = "AB", .metres = 300},
               {.vehicle = 3, .road = "AB", .metres = 100}});
  forecast.run(driven.fleet, Level(net), 0);
  const std::array<Millis, 4> expected{0, 2'000, 4'000, 20'000};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(forecast.leaving(VehicleId{i}).road, road(net, "AB")) << i;
    EXPECT_EQ(forecast.leaving(VehicleId{i}).time, expected[i]) << i;
  }
  EXPECT_FALSE(forecast.leaving(VehicleId{4U}).road.valid());
}

TEST_F(Queues, TheSameFleetGivesTheSameForecast) {
  Driven driven(net, 30);
  stand(driven, 20);
  for (std::size_t i = 20; i < 30; ++i) driven.load(i, "ABCD");
  const Discharge discharge(net, servers, driven.demand);
  QueueForecast first(net, servers, discharge, nobody_assumed);
  QueueForecast again(net, servers, discharge, nobody_assumed);
  first.run(driven.fleet, Level(net), 0);
  for (int run = 0; run < 3; ++run) again.run(driven.fleet, Level(net), 0);
  for (std::size_t bin = 0; bin < 60; ++bin) EXPECT_EQ(wait(first, "AB", bin), wait(again, "AB", bin));
  for (std::size_t i = 20; i < 30; ++i)
    EXPECT_EQ(first.insertion(VehicleId{i}), again.insertion(VehicleId{i})) << i;
}

}  // namespace
}  // namespace thalweg::testing
