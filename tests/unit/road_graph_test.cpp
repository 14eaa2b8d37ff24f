// SPDX-License-Identifier: Apache-2.0
#include "graph/road_graph.hpp"

#include <gtest/gtest.h>

#include <set>

#include "support/ascii_network.hpp"

namespace thalweg::testing {
namespace {

constexpr TurnPenalties no_penalties{.minor = 0, .turnaround = 0, .signal = 0};

/// The turns as "AB BC", sorted; a parallel one appears again.
std::multiset<std::string> turns_of(const Network& network, const RoadGraph& graph) {
  std::multiset<std::string> turns;
  for (std::size_t i = 0; i < graph.turns().arc_count(); ++i) {
    const auto [tail, head] = graph.turns().ends(ArcId{i});
    turns.insert(names(network, graph, {tail, head}));
  }
  return turns;
}

Millis turn_cost(const Network& network, const RoadGraph& graph, const RoadTimes& times,
                 std::string_view from, std::string_view to) {
  std::vector<Millis> costs;
  turn_costs(graph, times, costs);
  Millis least = infinity;
  for (const Arc& arc : graph.turns().out(vertex(network, graph, from))) {
    if (arc.end == vertex(network, graph, to)) least = std::min(least, costs[arc.id.value]);
  }
  return least;
}

//     A-B-C
//       |
//       D
constexpr const char* tee = "A-B-C\n  |\n  D";

TEST(RoadGraph, RoadsAreVerticesAndTurnsAreArcs) {
  const Network net = ascii_network(tee);
  const RoadGraph graph(net, VehicleClass::passenger);
  EXPECT_EQ(graph.turns().vertex_count(), 6U);
  EXPECT_EQ(turns_of(net, graph),
            (std::multiset<std::string>{"AB BC", "AB BD", "CB BA", "CB BD", "DB BA", "DB BC"}));
  EXPECT_EQ(graph.turn_count(), 6U);
  for (const Road& road : net.roads) {
    const VertexId v = vertex(net, graph, road.id);
    EXPECT_EQ(net.roads[graph.road(v)].id, road.id);
    EXPECT_TRUE(graph.permitted(v));
  }
}

TEST(RoadGraph, TurnsAreThoseOfTheClass) {
  const Network net = ascii_network(tee, {.roads = {{"BC", {.permissions = "allow=\"bus\""}},
                                                    {"BD", {.permissions = "disallow=\"bus\""}}}});
  const RoadGraph cars(net, VehicleClass::passenger);
  EXPECT_EQ(turns_of(net, cars), (std::multiset<std::string>{"AB BD", "CB BA", "CB BD", "DB BA"}));
  EXPECT_FALSE(cars.permitted(vertex(net, cars, "BC"))) << "a vertex all the same, without turns";
  const RoadGraph buses(net, VehicleClass::bus);
  EXPECT_EQ(turns_of(net, buses), (std::multiset<std::string>{"AB BC", "CB BA", "DB BA", "DB BC"}));
  const RoadGraph any(net, VehicleClass::ignoring);
  EXPECT_EQ(any.turn_count(), 6U);
}

/// AB (2 lanes) to BC (2 lanes) over the internal roads that `connections` name; each lane's `allow` to set.
std::string two_lane_net(const std::string& kerb_allow, const std::string& connections) {
  return R"(<net>
<edge id=":B_0" function="internal"><lane id=":B_0_0" length="20" speed="10"/></edge>
<edge id=":B_1" function="internal"><lane id=":B_1_0" length="30" speed="10"/></edge>
<edge id=":B_2" function="internal"><lane id=":B_2_0" length="40" speed="10"/></edge>
<edge id="AB" from="A" to="B">
  <lane id="AB_0" length="100" speed="10" )" +
         kerb_allow + R"(/><lane id="AB_1" length="100" speed="10"/>
</edge>
<edge id="BC" from="B" to="C">
  <lane id="BC_0" length="100" speed="10"/><lane id="BC_1" length="100" speed="10"/>
</edge>
<junction id="A" x="0" y="0"/><junction id="B" x="0" y="0"/><junction id="C" x="0" y="0"/>
)" + connections +
         "</net>";
}

std::string lane_connection(int lane, const std::string& more) {
  return "<connection from=\"AB\" to=\"BC\" fromLane=\"" + std::to_string(lane) + "\" toLane=\"" +
         std::to_string(lane) + "\" " + more + "/>\n";
}

TEST(RoadGraph, EachWayThroughAJunctionIsAnArc) {
  const Network net = parse_network(
      two_lane_net("", lane_connection(0, "via=\":B_0_0\"") + lane_connection(1, "via=\":B_1_0\"")));
  const RoadGraph graph(net, VehicleClass::passenger);
  EXPECT_EQ(turns_of(net, graph), (std::multiset<std::string>{"AB BC", "AB BC"}));
  EXPECT_EQ(graph.turn_count(), 1U);
  const RoadTimes times = free_flow_times(net, VehicleClass::passenger, 50, no_penalties);
  EXPECT_EQ(turn_cost(net, graph, times, "AB", "BC"), 10'000 + 2'000);
}

TEST(RoadGraph, LanesOfOneInternalRoadAreOneArc) {
  const Network net = parse_network(
      two_lane_net("", lane_connection(0, "via=\":B_0_0\"") + lane_connection(1, "via=\":B_0_0\"")));
  EXPECT_EQ(RoadGraph(net, VehicleClass::passenger).turns().arc_count(), 1U);
}

TEST(RoadGraph, ATurnNeedsItsLanesAndItsConnection) {
  const std::string both = lane_connection(0, "via=\":B_0_0\"") + lane_connection(1, "via=\":B_1_0\"");
  const Network bus_lane = parse_network(two_lane_net("allow=\"bus\"", both));
  const RoadGraph cars(bus_lane, VehicleClass::passenger);
  const RoadTimes times = limit_times(bus_lane);
  EXPECT_EQ(turn_cost(bus_lane, cars, times, "AB", "BC"), 13'000) << "the short way starts on the bus lane";
  EXPECT_TRUE(cars.permitted(vertex(bus_lane, cars, "AB")));
  const RoadGraph buses(bus_lane, VehicleClass::bus);
  EXPECT_EQ(turn_cost(bus_lane, buses, times, "AB", "BC"), 12'000);
  const Network no_trucks = parse_network(two_lane_net("", lane_connection(0, "disallow=\"truck\"")));
  EXPECT_EQ(RoadGraph(no_trucks, VehicleClass::truck).turn_count(), 0U);
  EXPECT_EQ(RoadGraph(no_trucks, VehicleClass::passenger).turn_count(), 1U);
}

TEST(RoadGraph, InternalRoadsAreChained) {
  const Network net = parse_network(
      two_lane_net("", lane_connection(0, "via=\":B_0_0\"") +
                           "<connection from=\":B_0\" to=\"BC\" fromLane=\"0\" toLane=\"0\" via=\":B_2_0\"/>"
                           "<connection from=\":B_2\" to=\"BC\" fromLane=\"0\" toLane=\"0\"/>"));
  const RoadGraph graph(net, VehicleClass::passenger);
  ASSERT_EQ(graph.turns().arc_count(), 1U);
  const auto through = graph.junction_roads(ArcId{0U});
  EXPECT_EQ(names(net, {through.begin(), through.end()}), ":B_0 :B_2");
  EXPECT_EQ(turn_cost(net, graph, limit_times(net), "AB", "BC"), 10'000 + 2'000 + 4'000);
}

TEST(RoadGraph, AChainThatIsALoopEnds) {
  const Network net = parse_network(two_lane_net(
      "", lane_connection(0, "via=\":B_0_0\"") +
              "<connection from=\":B_0\" to=\"BC\" fromLane=\"0\" toLane=\"0\" via=\":B_1_0\"/>"
              "<connection from=\":B_1\" to=\"BC\" fromLane=\"0\" toLane=\"0\" via=\":B_0_0\"/>"));
  const RoadGraph graph(net, VehicleClass::passenger);
  EXPECT_EQ(graph.junction_roads(ArcId{0U}).size(), 2U);
}

//     A=B-C      BC leads back to AB
TEST(RoadGraph, SaysWhatTurnsBack) {
  const Network net = parse_network(
      two_lane_net("", lane_connection(0, "via=\":B_0_0\" dir=\"s\"") +
                           "<connection from=\"BC\" to=\"AB\" fromLane=\"0\" toLane=\"0\" dir=\"t\"/>"));
  const RoadGraph graph(net, VehicleClass::passenger);
  const auto turns_back = [&](const char* from) {
    return graph.turns_back(graph.turns().out(vertex(net, graph, from)).front().id);
  };
  EXPECT_FALSE(turns_back("AB"));
  EXPECT_TRUE(turns_back("BC"));
}

//     A--B-C      200 m and 100 m at 10 m/s, 20 m on the junction
TEST(RoadGraph, ATurnCostsTheRoadThatIsLeftAndTheJunction) {
  const Network net = ascii_network("A--B-C", {.junction_metres = 20});
  const RoadGraph graph(net, VehicleClass::passenger);
  const RoadTimes times = free_flow_times(net, VehicleClass::passenger, 50, no_penalties);
  EXPECT_EQ(turn_cost(net, graph, times, "AB", "BC"), 20'000 + 2'000);
  EXPECT_EQ(turn_cost(net, graph, times, "CB", "BA"), 10'000 + 2'000);
}

TEST(FreeFlow, IsTheFastestLaneAtTheClassesSpeed) {
  const Network net = parse_network(R"(<net>
<type id="side"><restriction vClass="bus" speed="4"/></type>
<edge id="AB" from="A" to="B" type="side">
  <lane id="AB_0" length="100" speed="5"/><lane id="AB_1" length="90" speed="20"/>
</edge>
<junction id="A" x="0" y="0"/><junction id="B" x="0" y="0"/>
</net>)");
  const auto time = [&](VehicleClass vehicle_class, double max_speed) {
    return free_flow_times(net, vehicle_class, max_speed, no_penalties)[road(net, "AB")];
  };
  EXPECT_EQ(time(VehicleClass::passenger, 50), 4'500);
  EXPECT_EQ(time(VehicleClass::passenger, 10), 9'000);
  EXPECT_EQ(time(VehicleClass::bus, 50), 22'500) << "the restriction of the road's type";
}

TEST(FreeFlow, PenaltiesLieOnTheTurnsInternalRoad) {
  const Network net = parse_network(
      two_lane_net("", lane_connection(0, "via=\":B_0_0\" state=\"m\"") +
                           lane_connection(1, "via=\":B_1_0\" state=\"M\"") +
                           "<connection from=\"BC\" to=\"AB\" fromLane=\"0\" toLane=\"0\" via=\":B_2_0\" "
                           "dir=\"t\" state=\"m\"/>"));
  const RoadTimes times =
      free_flow_times(net, VehicleClass::passenger, 50, {.minor = 1'500, .turnaround = 5'000, .signal = 700});
  EXPECT_EQ(times[road(net, ":B_0")], 2'000 + 1'500);
  EXPECT_EQ(times[road(net, ":B_1")], 3'000) << "it has the right of way";
  EXPECT_EQ(times[road(net, ":B_2")], 4'000 + 5'000) << "a turn-around, if it gives way or not";
  EXPECT_EQ(times[road(net, "AB")], 10'000);
  EXPECT_EQ(times[road(net, "BC")], 10'000);
  const Network signals = parse_network(two_lane_net(
      "", lane_connection(0, "via=\":B_0_0\" state=\"o\" tl=\"B\" linkIndex=\"0\"") +
              lane_connection(1, "via=\":B_1_0\" state=\"o\" tl=\"B\" linkIndex=\"1\" dir=\"t\"")));
  const RoadTimes signalled = free_flow_times(signals, VehicleClass::passenger, 50,
                                              {.minor = 1'500, .turnaround = 5'000, .signal = 700});
  EXPECT_EQ(signalled[road(signals, ":B_0")], 2'000 + 700);
  EXPECT_EQ(signalled[road(signals, ":B_1")], 3'000 + 700)
      << "a signalled turn-around: the signal counts last";
}

//     A-B-C      BC has the limit 0
TEST(FreeFlow, ALimitOfZeroClosesTheRoad) {
  const Network net =
      ascii_network("A-B-C", {.roads = {{"BC", {.speed = 0}}, {"CB", {.length = 0, .speed = 0}}}});
  const RoadTimes times = limit_times(net);
  EXPECT_EQ(times[road(net, "BC")], infinity);
  EXPECT_EQ(times[road(net, "CB")], infinity) << "0 / 0";
  const RoadGraph graph(net, VehicleClass::passenger);
  EXPECT_EQ(turn_cost(net, graph, times, "CB", "BA"), infinity);
  EXPECT_EQ(turn_cost(net, graph, times, "AB", "BC"), 10'000) << "the last road of a route is not in it";
}

TEST(FreeFlow, ARoadWithoutLengthTakesNoTime) {
  const Network net = ascii_network("A-B", {.roads = {{"AB", {.length = 0}}}});
  EXPECT_EQ(limit_times(net)[road(net, "AB")], 0);
}

}  // namespace
}  // namespace thalweg::testing
