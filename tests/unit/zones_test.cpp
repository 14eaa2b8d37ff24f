// SPDX-License-Identifier: Apache-2.0
#include "network/zones.hpp"

#include <gtest/gtest.h>

#include "routing/trip_router.hpp"
#include "support/ascii_network.hpp"
#include "support/input_error.hpp"
#include "support/temporary_folder.hpp"

namespace thalweg::testing {
namespace {

//   A---B---C---D      30 s a road (AB 25 s and no lorries, CB 40 s), 10 s those down
//       |   |
//       E---F
class Zones : public ::testing::Test {
 protected:
  void add(const std::string& content) {
    add_zones(folder.write("zones.add.xml", "<additional>\n" + content + "</additional>"), net);
  }

  /// The route between two roads or zones, and its cost; "-": there is none. What is wrong comes as it is.
  std::string way(std::string_view from, std::string_view to,
                  VehicleClass vehicle_class = VehicleClass::passenger) {
    std::string routes;
    for (const auto* const name : {"dijkstra", "evolved", "cch"}) {
      TripRouter router(net, {}, make_strategy(name, {.rule = {.relative = 0, .spread = 0, .absolute = 0}}));
      const std::array<std::string_view, 2> ends{from, to};
      auto problem = router.add(vehicle_class, 100, ends);
      if (!problem.empty()) return problem;
      router.route();
      const auto found = router.result(0);
      const std::string route = found ? fmt::format("{} {} s", found->edges, to_seconds(found->cost)) : "-";
      if (routes.empty()) routes = route;
      EXPECT_EQ(route, routes) << name;
    }
    return routes;
  }

  Network net = ascii_network(
      "A---B---C---D\n"
      "    |   |\n"
      "    E---F\n",
      {.roads = {{"AB", {.length = 250, .permissions = R"(disallow="truck")"}}, {"CB", {.length = 400}}}});
  TemporaryFolder folder;
};

TEST_F(Zones, TheBestPairIsTakenWhateverTheWeights) {
  add(R"(<taz id="w"><tazSource id="AB" weight="9"/><tazSource id="BC" weight="0"/></taz>
         <taz id="e"><tazSink id="EF" weight="9"/><tazSink id="CD" weight="0"/></taz>)");
  EXPECT_EQ(way(zone_source("w"), zone_sink("e")), "BC CD 60 s");
  EXPECT_EQ(way(zone_source("w"), "BE"), "AB BE 35 s");
  EXPECT_EQ(way("BE", zone_sink("e")), "BE EF 40 s");
}

TEST_F(Zones, EdgesAreBothBeginningsAndEnds) {
  add(R"(<taz id="w" edges="AB BA"/>)");
  EXPECT_EQ(way(zone_source("w"), zone_sink("w")), "AB 25 s");
  EXPECT_EQ(way(zone_source("w"), "CD"), "AB BC CD 85 s");
  EXPECT_EQ(way("CB", zone_sink("w")), "CB BA 70 s");
}

TEST_F(Zones, AClassBeginsWhereItMayDrive) {
  add(R"(<taz id="w" edges="AB BC"/><taz id="a" edges="AB"/>)");
  EXPECT_EQ(way(zone_source("w"), "BE"), "AB BE 35 s");
  EXPECT_EQ(way(zone_source("w"), "CD", VehicleClass::truck), "BC CD 60 s");
  EXPECT_EQ(way(zone_source("a"), "CD", VehicleClass::truck), "-");
}

TEST_F(Zones, NobodyTurnsAroundInAZone) {
  add(R"(<taz id="d" edges="DC CD"/>)");
  EXPECT_EQ(way("DC", "CD"), "DC CF FE EB BC CD 140 s");
}

TEST_F(Zones, WhatIsWrongIsNamed) {
  EXPECT_NE(input_error([&] { add(R"(<taz id="w" edges="AB XY"/>)"); })
                .find("zones.add.xml:2: <taz id='w'>: "
                      "the edge 'XY'"),
            std::string::npos);
  EXPECT_NE(input_error([&] { add(R"(<taz id="s"><tazSource id="XY" weight="1"/></taz>)"); }).find("'XY'"),
            std::string::npos);
  EXPECT_NE(input_error([&] { add(R"(<taz id="v"/><taz id="v"/>)"); }).find("already"), std::string::npos);
  EXPECT_NE(input_error([&] { add("<taz/>"); }).find("id"), std::string::npos);
  add(R"(<taz id="none"/>)");
  EXPECT_EQ(way(zone_source("none"), "CD"), "-");
  EXPECT_NE(way(zone_source("what"), "CD").find("'what-source' is not in the net"), std::string::npos);
}

}  // namespace
}  // namespace thalweg::testing
