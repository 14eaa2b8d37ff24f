// SPDX-License-Identifier: Apache-2.0
#include "traffic/timed_costs.hpp"

#include <gtest/gtest.h>

#include "network/read_network.hpp"
#include "support/expecting.hpp"

namespace thalweg::testing {
namespace {

class TimedCostsTest : public Expecting {
 protected:
  using Expecting::Expecting;
  [[nodiscard]] ArcId turn(const char* from) const {
    return graph.turns().out(vertex(net, graph, from)).front().id;
  }
  /// Looks ahead from where they stand, and makes the costs of it.
  void refresh(const Driven& driven, const Conditions& conditions, Millis now = 0) {
    queues.run(driven.fleet, level, now);
    costs.refresh(expected(conditions), now);
  }

  RoadGraph graph{net, VehicleClass::passenger};
  TimedCosts costs{net, graph};
};

TEST_F(TimedCostsTest, AreFreeFlowWhereNobodyIs) {
  refresh(Driven(net, 1), unchanged);
  for (const Millis time : {Millis{0}, Millis{7}, Millis{999'000}, Millis{10'000'000}})
    EXPECT_EQ(costs.arrive(turn("AB"), time), time + 30'000);
}

// Thirty stand at the end of AB for a minute. Who enters AB now reaches them in 30 s, waits for what is left
// of the minute, and who enters later waits less, but never passes anybody.
TEST_F(TimedCostsTest, FollowTheQueueAndNobodyPasses) {
  refresh(crowded(net, 30), unchanged);
  EXPECT_NEAR(to_seconds(costs.arrive(turn("AB"), 0)), 60, 4);
  EXPECT_EQ(costs.arrive(turn("AB"), 200'000), 230'000);
  Millis last = 0;
  for (Millis time = 0; time < 400'000; time += 500) {
    const Millis arrival = costs.arrive(turn("AB"), time);
    EXPECT_GE(arrival, last) << time;
    EXPECT_GE(arrival, time + 30'000);
    EXPECT_GE(arrival, time + costs.least()[turn("AB").value]);
    last = arrival;
  }
  EXPECT_EQ(costs.least()[turn("AB").value], 30'000) << "when the queue has gone";
}

// Five more come into that queue: who enters AB now waits for them as well, 2 s each.
TEST_F(TimedCostsTest, SeeWhatWasBooked) {
  refresh(crowded(net, 30), unchanged);
  const Millis before = costs.arrive(turn("AB"), 0);
  bookings.book(road(net, "AB"), 5, 5);
  ASSERT_EQ(bookings.take_changed(), std::vector<RoadId>{road(net, "AB")});
  costs.refresh(expected(unchanged), road(net, "AB"));
  EXPECT_NEAR(to_seconds(costs.arrive(turn("AB"), 0) - before), 10, 0.1);
}

// A road that is measured at 100 s where the model says 30 s costs more now, and less and less of it later; a
// part of it lasts.
TEST_F(TimedCostsTest, WhatWasMeasuredMovesThemAndFades) {
  const MeasuredTimes measured = slow_road(net, "AB");
  EXPECT_NEAR(measured.passage(road(net, "AB")).vehicle_seconds, 1800, 1);
  EXPECT_NEAR(measured.passage(road(net, "AB")).traversals, 1800 * 3 / 300.0, 0.1);
  residuals.learn(servers, level, table, measured, 15, 0);
  const double lasting = residuals.lasting(road(net, "AB"));
  const double passing = residuals.passing(road(net, "AB"));
  EXPECT_NEAR(lasting + passing, 70, 9) << "eight traversals' worth is left to the model";
  refresh(Driven(net, 1), unchanged);
  const double now = to_seconds(costs.arrive(turn("AB"), 0)) - 30;
  const double later = to_seconds(costs.arrive(turn("AB"), 900'000) - 900'000) - 30;
  EXPECT_NEAR(now, lasting + passing, 0.1);
  EXPECT_NEAR(later, lasting + passing * 0.3679, 0.5);
}

// Seen for long enough, what the model lacks is lasting, but for what is too much to be anything but a jam.
TEST_F(TimedCostsTest, WhatIsMeasuredAgainAndAgainLasts) {
  const MeasuredTimes measured = slow_road(net, "AB");
  for (Millis round = 0; round < 1000; ++round)
    residuals.learn(servers, level, table, measured, 15, round * 15'000);
  EXPECT_NEAR(residuals.lasting(road(net, "AB")), 20, 1);
  EXPECT_EQ(residuals.lasting(road(net, "BC")), 0);
}

// AB takes 100 s all the time, where the model says 30 s: for now that is made up by what was measured just
// now, most of which the forecast lets fade until five minutes later. That this is wrong shows after five
// minutes (and half of the three that are measured), and then those who enter AB later are foretold as well.
TEST_F(TimedCostsTest, WhatForecastsMissedLaterIsMadeUpForThere) {
  const MeasuredTimes measured = slow_road(net, "AB");
  const auto learn = [&](Millis from, Millis until) {
    for (Millis now = from; now < until; now += 15'000)
      residuals.learn(servers, level, table, measured, 15, now);
  };
  const auto takes = [&](Millis entry) {
    refresh(Driven(net, 1), unchanged);
    return to_seconds(costs.arrive(turn("AB"), entry) - entry);
  };
  learn(0, 390'000);
  EXPECT_EQ(residuals.late(road(net, "AB")), 0) << "nothing to compare with";
  EXPECT_LT(takes(300'000), 85);
  learn(390'000, 7'200'000);
  EXPECT_NEAR(takes(0), 94, 1) << "eight traversals' worth is left to the model";
  EXPECT_NEAR(takes(300'000), 100, 5);
  EXPECT_EQ(residuals.late(road(net, "BC")), 0) << "nobody was there";
}

// At night nobody is there to show that the jam of the day is over: what was learned from it fades.
TEST_F(TimedCostsTest, WhatNobodySeesAnyMoreIsForgotten) {
  const MeasuredTimes slow = slow_road(net, "AB");
  const MeasuredTimes nobody(net, 180'000, 1'000);
  Millis now = 0;
  for (; now < 7'200'000; now += 15'000) residuals.learn(servers, level, table, slow, 15, now);
  EXPECT_GT(residuals.lasting(road(net, "AB")), 15);
  EXPECT_GT(residuals.late(road(net, "AB")), 10);
  for (; now < 36'000'000; now += 15'000) residuals.learn(servers, level, table, nobody, 15, now);
  EXPECT_NEAR(residuals.lasting(road(net, "AB")), 0, 0.1);
  EXPECT_NEAR(residuals.late(road(net, "AB")), 0, 0.1);
}

// BC is closed for ten seconds, and slow from then on.
TEST_F(TimedCostsTest, KnowWhatIsClosedAndWhatIsSlow) {
  const Driven driven(net, 1);
  const auto lane = [&](const char* id) { return net.roads[road(net, id)].first_lane; };
  Conditions conditions(net, {{.lane = lane("BC"), .end = 10'000, .permissions = Permissions::none()},
                              {.lane = lane("BC"), .begin = 10'000, .speed = 2}});
  conditions.advance(0);
  refresh(driven, conditions);
  EXPECT_GE(costs.arrive(turn("AB"), 0), TimedCosts::closed);
  EXPECT_EQ(costs.least()[turn("AB").value], infinity);
  EXPECT_EQ(costs.arrive(turn("BC"), 0), 30'000) << "who is there may leave";
  conditions.advance(10'000);
  refresh(driven, conditions, 10'000);
  EXPECT_EQ(costs.arrive(turn("AB"), 10'000), 40'000);
  EXPECT_EQ(costs.arrive(turn("BC"), 10'000), 160'000) << "300 m at 2 m/s";
  EXPECT_EQ(costs.least()[turn("BC").value], 150'000) << "nobody will find it faster";
}

//     A---B---C      at B one may turn back; AB and BA have room for 40
class TurningBack : public TimedCostsTest {
 protected:
  TurningBack() : TimedCostsTest(ascii_network("A---B---C", {.turn_arounds = true})) {}
  /// s from AB to this road, when so many stand on BA.
  [[nodiscard]] double time_to(const char* to, std::size_t on_ba) {
    Driven driven(net, 40);
    std::vector<Driven::At> places;
    for (std::size_t i = 0; i < on_ba; ++i) {
      driven.load(i, "BA");
      places.push_back({.vehicle = i, .road = "BA", .metres = 290 - 7.5 * static_cast<double>(i)});
    }
    driven.look(places);
    refresh(driven, unchanged);
    for (const Arc& arc : graph.turns().out(vertex(net, graph, "AB"))) {
      if (arc.end == vertex(net, graph, to)) return to_seconds(costs.arrive(arc.id, 0));
    }
    return -1;
  }
};

TEST_F(TurningBack, IsALastResortWhereTheRoadIsHalfFull) {
  EXPECT_NEAR(time_to("BA", 19), 30, 0.1);
  EXPECT_NEAR(time_to("BA", 20), 150, 0.1);
  EXPECT_NEAR(time_to("BC", 40), 30, 0.1) << "straight on is as before";
}

//     A --150 m--> B --> C     at B a signal, from 0 s on: 30 s red, 30 s green
constexpr const char* signalled = R"(<net>
  <edge id=":B_0" function="internal"><lane id=":B_0_0" index="0" length="20" speed="10"/></edge>
  <edge id="AB" from="A" to="B"><lane id="AB_0" index="0" length="150" speed="10"/></edge>
  <edge id="BC" from="B" to="C"><lane id="BC_0" index="0" length="150" speed="10"/></edge>
  <tlLogic id="B" type="static" programID="0" offset="0">
    <phase duration="30" state="r"/><phase duration="30" state="G"/></tlLogic>
  <junction id="A" x="0" y="0"/><junction id="B" x="0" y="0"/><junction id="C" x="0" y="0"/>
  <connection from="AB" to="BC" fromLane="0" toLane="0" via=":B_0_0" tl="B" linkIndex="0" dir="s" state="O"/>
  <connection from=":B_0" to="BC" fromLane="0" toLane="0" dir="s" state="M"/>
</net>)";

class AtASignal : public TimedCostsTest {
 protected:
  AtASignal() : TimedCostsTest(parse_network(signalled)) {
    SignalProgramme programme = net.signals[SignalId{0U}].programmes.front();
    programme.cycle_start = 0;
    servers.set_programme(SignalId{0U}, programme);
  }
  /// When who enters AB at this time is on BC.
  [[nodiscard]] double arrival(Millis entry) const { return to_seconds(costs.arrive(turn("AB"), entry)); }
  /// So many stand at the end of AB, at most 18, and the others wait to get on it.
  void stand(std::size_t queue) {
    Driven driven(net, 40);
    std::vector<Driven::At> places;
    for (std::size_t i = 0; i < queue; ++i) {
      driven.load(i, "ABC");
      if (i < 18) places.push_back({.vehicle = i, .road = "AB", .metres = 145});
    }
    driven.look(places);
    refresh(driven, unchanged);
  }
};

TEST_F(AtASignal, CostsKnowWhatItShows) {
  stand(0);
  const double in_mean = 15 + 30 * 30 / 120.0 + 1 + 2;  // to the line, the mean wait, the junction
  const double mean = 465 / 60.0;                       // of 30, 29 .. 1 and thirty times 0
  EXPECT_NEAR(arrival(0), in_mean + 15 - mean, 1) << "comes in the middle of the red";
  EXPECT_NEAR(arrival(30'000), 30 + in_mean - mean, 1) << "in the middle of the green";
  EXPECT_NEAR(arrival(45'500), 45.5 + in_mean, 8) << "as it closes: nobody can tell";
  EXPECT_NEAR(arrival(1'000'000), 1000 + in_mean, 0.1) << "nor in a quarter of an hour";
  double last = 0;
  for (Millis entry = 0; entry < 600'000; entry += 250) {
    EXPECT_GE(arrival(entry), last - 0.1) << entry << ": nobody passes";
    EXPECT_GE(costs.arrive(turn("AB"), entry), entry + costs.least()[turn("AB").value]);
    last = arrival(entry);
  }
}

TEST_F(AtASignal, CostsAreThoseOfTheQueueWhereOneStands) {
  stand(40);
  const double early = arrival(0);
  for (const Millis start : {Millis{10'000}, Millis{40'000}}) {
    SignalProgramme programme = net.signals[SignalId{0U}].programmes.front();
    programme.cycle_start = start;
    servers.set_programme(SignalId{0U}, programme);
    stand(40);
    EXPECT_EQ(arrival(0), early) << "whatever is shown when it gets there";
  }
}

}  // namespace
}  // namespace thalweg::testing
