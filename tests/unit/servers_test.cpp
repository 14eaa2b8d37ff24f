// SPDX-License-Identifier: Apache-2.0
#include "traffic/servers.hpp"

#include <gtest/gtest.h>

#include "network/read_network.hpp"
#include "support/ascii_network.hpp"

namespace thalweg::testing {
namespace {

//     A ==2 lanes==> B --> C       at B a signal: 30 s green, 3 s yellow, 27 s red for link 0 (to C) and
//                    |             27 s of permissive green for link 1 (to D)
//                    D
constexpr const char* signalled = R"(<net>
  <edge id=":B_0" function="internal"><lane id=":B_0_0" index="0" length="20" speed="10"/></edge>
  <edge id=":B_1" function="internal"><lane id=":B_1_0" index="0" length="5" speed="5"/></edge>
  <edge id="AB" from="A" to="B"><lane id="AB_0" index="0" length="150" speed="10"/>
                                <lane id="AB_1" index="1" length="150" speed="15"/></edge>
  <edge id="BC" from="B" to="C"><lane id="BC_0" index="0" length="3" speed="10"/></edge>
  <edge id="BD" from="B" to="D"><lane id="BD_0" index="0" length="150" speed="10"/></edge>
  <tlLogic id="B" type="static" programID="0" offset="0">
    <phase duration="30" state="Gr"/><phase duration="3" state="yr"/><phase duration="27" state="rg"/></tlLogic>
  <junction id="A" x="0" y="0"/><junction id="B" x="0" y="0"/><junction id="C" x="0" y="0"/>
  <junction id="D" x="0" y="0"/>
  <connection from="AB" to="BC" fromLane="0" toLane="0" via=":B_0_0" tl="B" linkIndex="0" dir="s" state="o"/>
  <connection from="AB" to="BC" fromLane="1" toLane="0" via=":B_0_0" tl="B" linkIndex="0" dir="s" state="o"/>
  <connection from="AB" to="BD" fromLane="0" toLane="0" via=":B_1_0" tl="B" linkIndex="1" dir="r" state="o"/>
  <connection from=":B_0" to="BC" fromLane="0" toLane="0" dir="s" state="M"/>
  <connection from=":B_1" to="BD" fromLane="0" toLane="0" dir="s" state="M"/>
</net>)";

TEST(Servers, TakeTheGreenShareOfTheirLinks) {
  const Network net = parse_network(signalled);
  const Servers servers(net);
  ASSERT_EQ(servers.size(), 2U);
  const MovementId to_c = servers.find(road(net, "AB"), road(net, "BC"));
  const MovementId to_d = servers.find(road(net, "AB"), road(net, "BD"));
  // Green 30 s and 0.3 of 3 s of 60 s; red 27 s and half of the yellow.
  EXPECT_DOUBLE_EQ(servers[to_c].headway, 2 / ((30 + 0.3 * 3) / 60));
  EXPECT_DOUBLE_EQ(servers[to_c].delay, 28.5 * 28.5 / 120 + 1);
  EXPECT_DOUBLE_EQ(servers[to_d].headway, 2 / (0.5 * 27 / 60));
  EXPECT_DOUBLE_EQ(servers[to_c].through, 2);
  EXPECT_DOUBLE_EQ(servers[to_d].through, 1);
  EXPECT_EQ(servers.lanes(to_c).size(), 2U);
  EXPECT_EQ(servers.lanes(to_d).size(), 1U);
  EXPECT_DOUBLE_EQ(servers.free_flow(road(net, "AB")), 10) << "by its fastest lane";
  EXPECT_DOUBLE_EQ(servers.storage(road(net, "AB")), 40);
  EXPECT_DOUBLE_EQ(servers.storage(road(net, "BC")), 2)
      << "on the shortest road one arrives while one leaves";
  EXPECT_FALSE(servers.find(road(net, "BC"), road(net, "AB")).valid());
}

TEST(Servers, FollowAChangeOfTheProgramme) {
  const Network net = parse_network(signalled);
  Servers servers(net);
  const MovementId to_c = servers.find(road(net, "AB"), road(net, "BC"));
  const double before = servers[to_c].headway;
  servers.set_programme(SignalId{0U}, {.id = "off", .type = {}, .offset = 0, .phases = {}});
  EXPECT_EQ(servers[to_c].headway, before) << "nothing is known: as it was";
  servers.set_programme(
      SignalId{0U}, {.id = "1", .type = {}, .offset = 0, .phases = {{.duration = 60'000, .state = "Gr"}}});
  EXPECT_DOUBLE_EQ(servers[to_c].headway, 2);
  EXPECT_DOUBLE_EQ(servers[to_c].delay, 1);
  EXPECT_DOUBLE_EQ(servers[servers.find(road(net, "AB"), road(net, "BD"))].headway, 2 / 0.03)
      << "never quite closed";
}

//     A ==> B --> C      from the kerb: a footway, a bus lane, a lane for all; the buses have a signal of
//                        their own, the cars have not
constexpr const char* street = R"(<net>
  <edge id=":B_0" function="internal"><lane id=":B_0_0" index="0" length="10" speed="2"/></edge>
  <edge id=":B_1" function="internal"><lane id=":B_1_0" index="0" length="10" speed="10"/></edge>
  <edge id="AB" from="A" to="B">
    <lane id="AB_0" index="0" length="150" speed="2" allow="pedestrian bicycle"/>
    <lane id="AB_1" index="1" length="150" speed="10" allow="bus"/>
    <lane id="AB_2" index="2" length="150" speed="10" disallow="pedestrian"/></edge>
  <edge id="BC" from="B" to="C"><lane id="BC_0" index="0" length="150" speed="2" allow="pedestrian bicycle"/>
    <lane id="BC_1" index="1" length="150" speed="10" allow="bus"/></edge>
  <tlLogic id="B" type="static" programID="0" offset="0">
    <phase duration="30" state="G"/><phase duration="30" state="r"/></tlLogic>
  <junction id="A" x="0" y="0"/><junction id="B" x="0" y="0"/><junction id="C" x="0" y="0"/>
  <connection from="AB" to="BC" fromLane="0" toLane="0" via=":B_0_0" dir="s" state="m"/>
  <connection from="AB" to="BC" fromLane="1" toLane="1" via=":B_1_0" tl="B" linkIndex="0" dir="s" state="o"/>
  <connection from="AB" to="BC" fromLane="2" toLane="1" via=":B_1_0" dir="s" state="M"/>
</net>)";

TEST(Servers, AreTheLanesThatCarsQueueOn) {
  const Network net = parse_network(street);
  const Servers servers(net);
  const MovementId to_c = servers.find(road(net, "AB"), road(net, "BC"));
  ASSERT_EQ(servers.lanes(to_c).size(), 1U);
  EXPECT_EQ(servers.lanes(to_c).front(), net.roads[road(net, "AB")].lane(2));
  EXPECT_DOUBLE_EQ(servers[to_c].headway, 2) << "no signal of the buses'";
  EXPECT_DOUBLE_EQ(servers[to_c].through, 1) << "not at a walk";
  EXPECT_EQ(servers.end(road(net, "AB")), RoadEnd::major) << "who walks gives way, who drives does not";
  EXPECT_DOUBLE_EQ(servers.storage(road(net, "AB")), 20) << "one lane of three";
  EXPECT_DOUBLE_EQ(servers.storage(road(net, "BC")), 20) << "no car may go there, but buses may";
}

//     A --> B -> C --> D     one signal at B and C; BC is 5 m long, and both are green for the same half
//     minute
constexpr const char* twice_signalled = R"(<net>
  <edge id="AB" from="A" to="B"><lane id="AB_0" index="0" length="150" speed="10"/></edge>
  <edge id="BC" from="B" to="C"><lane id="BC_0" index="0" length="5" speed="10"/></edge>
  <edge id="CD" from="C" to="D"><lane id="CD_0" index="0" length="150" speed="10"/></edge>
  <tlLogic id="S" type="static" programID="0" offset="0">
    <phase duration="30" state="GG"/><phase duration="30" state="rr"/></tlLogic>
  <junction id="A" x="0" y="0"/><junction id="B" x="0" y="0"/><junction id="C" x="0" y="0"/>
  <junction id="D" x="0" y="0"/>
  <connection from="AB" to="BC" fromLane="0" toLane="0" tl="S" linkIndex="0" dir="s" state="O"/>
  <connection from="BC" to="CD" fromLane="0" toLane="0" tl="S" linkIndex="1" dir="s" state="O"/>
</net>)";

TEST(Servers, WaitOnceAtTheStopLinesOfOneSignal) {
  const Network net = parse_network(twice_signalled);
  const Servers servers(net);
  const MovementId first = servers.find(road(net, "AB"), road(net, "BC"));
  const MovementId second = servers.find(road(net, "BC"), road(net, "CD"));
  EXPECT_DOUBLE_EQ(servers[first].delay, 30 * 30 / 120.0 + 1);
  EXPECT_LT(servers[second].delay, 3) << "it comes with green; only in the last second of it it is too late";
  EXPECT_DOUBLE_EQ(servers[first].headway, servers[second].headway);
}

// What a short road lets pass is what its servers let pass, not the three that find room on it in a mean red.
TEST(Servers, RoomIsNeverLessThanThoseInService) {
  const Network net = parse_network(twice_signalled);
  Servers servers(net);
  servers.set_programme(
      SignalId{0U}, {.id = "1",
                     .type = {},
                     .offset = 0,
                     .phases = {{.duration = 30'000, .state = "Gr"}, {.duration = 30'000, .state = "rG"}}});
  const Movement& leaving = servers[servers.find(road(net, "BC"), road(net, "CD"))];
  EXPECT_GT(leaving.delay, 10);
  EXPECT_DOUBLE_EQ(servers.storage(road(net, "BC")), 1 + leaving.delay / leaving.headway);
  EXPECT_DOUBLE_EQ(servers.storage(road(net, "CD")), 20) << "a last road is as long as it is";
}

}  // namespace
}  // namespace thalweg::testing
