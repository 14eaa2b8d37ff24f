// SPDX-License-Identifier: Apache-2.0
#include "traffic/fleet.hpp"

#include <gtest/gtest.h>

#include "support/queueing.hpp"

namespace thalweg::testing {
namespace {

//     A-B-C-D
//       |
//       E
TEST(Fleet, FollowsAVehicleAlongItsRoute) {
  const Network net = ascii_network("A-B-C-D\n  |\n  E", {.junction_metres = 5});
  Driven driven(net, 1);
  const FleetVehicle& vehicle = driven.fleet[VehicleId{0U}];
  EXPECT_TRUE(driven.fleet.present().empty());
  driven.load(0, "ABCD");
  EXPECT_EQ(vehicle.state, FleetVehicle::State::waiting);
  driven.look({{.vehicle = 0, .road = "AB", .metres = 30, .speed = 9}});
  EXPECT_EQ(vehicle.state, FleetVehicle::State::running);
  EXPECT_EQ(vehicle.metres, 30);
  EXPECT_EQ(driven.fleet.entered().size(), 1U) << "its first road";
  EXPECT_EQ(vehicle.position, 0U);

  std::string junction;
  for (const Road& road : net.roads) {
    if (road.function == RoadFunction::internal && junction.empty()) junction = road.id;
  }
  driven.look({{.vehicle = 0, .road = junction.c_str()}});
  EXPECT_TRUE(vehicle.on_junction);
  EXPECT_EQ(vehicle.position, 0U) << "the road that it comes from";
  EXPECT_TRUE(driven.fleet.entered().empty());
  driven.look({{.vehicle = 0, .road = "CD", .metres = 1}});
  EXPECT_EQ(vehicle.position, 2U) << "BC was passed between two looks";
  EXPECT_EQ(driven.fleet.entered().size(), 1U);
  driven.look({{.vehicle = 0, .road = "CD", .metres = 60}});
  EXPECT_TRUE(driven.fleet.entered().empty()) << "still on CD";
  driven.fleet.on_arrived(VehicleId{0U});
  driven.look({});
  EXPECT_TRUE(driven.fleet.present().empty());
}

TEST(Fleet, WhoIsNotWhereItsRouteSaysIsLostUntilItIsSeenThere) {
  const Network net = ascii_network("A-B-C-D\n  |\n  E");
  Driven driven(net, 1);
  const FleetVehicle& vehicle = driven.fleet[VehicleId{0U}];
  driven.load(0, "ABCD");
  driven.look({{.vehicle = 0, .road = "BE"}});
  EXPECT_TRUE(vehicle.is_lost);
  driven.look({});  // teleporting
  EXPECT_TRUE(vehicle.is_lost);
  driven.look({{.vehicle = 0, .road = "BC"}});
  EXPECT_FALSE(vehicle.is_lost);
  driven.fleet.on_route(VehicleId{0U}, way(net, "BE"));
  EXPECT_EQ(vehicle.route, (std::vector<RoadId>{road(net, "AB"), road(net, "BE")}));
}

TEST(Fleet, AWayThatSomebodyElseGaveIsTakenOver) {
  const Network net = ascii_network("A-B-C-D\n  |\n  E");
  Driven driven(net, 1);
  const FleetVehicle& vehicle = driven.fleet[VehicleId{0U}];
  driven.load(0, "ABCD");
  driven.look({{.vehicle = 0, .road = "AB"}});
  driven.fleet.on_plan(VehicleId{0U}, way(net, "BCD"));  // it has gone on since
  EXPECT_EQ(names(net, vehicle.route), names(net, way(net, "ABCD"))) << "the same way";
  driven.fleet.on_plan(VehicleId{0U}, way(net, "ABE"));
  EXPECT_EQ(names(net, vehicle.route), names(net, way(net, "ABE")));
  driven.look({{.vehicle = 0, .road = "BE"}});
  EXPECT_FALSE(vehicle.is_lost);
}

}  // namespace
}  // namespace thalweg::testing
