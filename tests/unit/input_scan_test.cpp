// SPDX-License-Identifier: Apache-2.0
#include "demand/input_scan.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "demand/vehicle_file.hpp"
#include "support/ascii_network.hpp"
#include "support/input_error.hpp"
#include "support/temporary_folder.hpp"
#include "xml/node.hpp"

namespace thalweg::testing {
namespace {

//   A---B---C
class Scan : public ::testing::Test {
 protected:
  /// Scans a route file with this content; what is left of it, as "id id ..".
  std::string left_of(const std::string& content) {
    const auto file = folder.write("demand.rou.xml", "<routes>" + content + "</routes>");
    scan_demand(file, folder / "copy.xml", net, false, scan);
    std::string ids;
    copy.clear();
    xml::read_nodes(folder / "copy.xml", [&](const xml::Node& node) {
      ids += (ids.empty() ? "" : " ") + node.require("id");
      copy.push_back(node);
    });
    return ids;
  }
  [[nodiscard]] std::string dropped() const {
    std::string text;
    for (const auto& [id, reason] : scan.dropped) text += fmt::format("{}: {}\n", id, reason);
    return text;
  }

  Network net = ascii_network("A---B---C\n");
  TemporaryFolder folder;
  InputScan scan;
  std::vector<xml::Node> copy;
};

TEST_F(Scan, WhoDrivesABrokenRouteIsDropped) {
  EXPECT_EQ(left_of(R"(
<route id="good" edges="AB BC"/><route id="bad" edges="AB nix"/>
<routeDistribution id="mixed"><route id="inner" edges="AB"/><route id="other" edges="nought BC"/></routeDistribution>
<routeDistribution id="named" routes="good bad" probabilities="1 1"/>
<vehicle id="v" route="good" depart="0"/><vehicle id="w" route="bad" depart="0"/>
<vehicle id="x" route="mixed" depart="0"/><vehicle id="y" route="inner" depart="0"/>
<vehicle id="z" route="named" depart="0"/><flow id="f" route="bad" begin="0" end="9" number="2"/>)"),
            "good v");
  EXPECT_EQ(dropped(),
            "w: the edge 'nix' is not in the net\n"
            "x: the edge 'nought' is not in the net\n"
            "y: the edge 'nought' is not in the net\n"
            "z: the edge 'nix' is not in the net\n"
            "f.0: the edge 'nix' is not in the net\n"
            "f.1: the edge 'nix' is not in the net\n");
}

TEST_F(Scan, WhoIsOverBeforeTheBeginIsInNoSimulation) {
  scan.begin = 100'000;
  EXPECT_EQ(left_of(R"(
<trip id="early" from="AB" to="BC" depart="99.9"/><trip id="due" from="AB" to="BC" depart="0:01:40"/>
<trip id="triggered" from="AB" to="BC" depart="triggered"/><trip id="odd" from="AB" to="BC" depart="-5"/>
<flow id="over" from="AB" to="BC" begin="0" end="100" probability="0.1"/>
<flow id="on" from="AB" to="BC" begin="0" end="200" probability="0.1"/>
<flow id="regular" from="AB" to="BC" begin="0" end="200" period="10"/>
<trip id="lost" from="AB" to="nix" depart="1"/>)"),
            "due triggered odd on regular");
  EXPECT_EQ(dropped(), "") << "nobody misses them, not even for an unknown road";
  EXPECT_EQ(scan.ids, (std::vector<std::string>{"due", "triggered", "odd"}));
  EXPECT_EQ(scan.flows, (std::vector<std::string>{"on", "regular"}));
  EXPECT_EQ(copy.at(3).value_or("begin", ""), "100.00") << "duarouter does not return from it otherwise";
  EXPECT_EQ(copy.at(4).value_or("begin", ""), "0") << "its vehicles depart by its own clock";
}

TEST_F(Scan, AFlowWithoutAnEndEndsWithTheSimulation) {
  scan.end = 300'000;
  EXPECT_EQ(left_of(R"(
<flow id="open" from="AB" to="BC" begin="0" period="9"/><flow id="counted" from="AB" to="BC" begin="0" number="2"/>
<flow id="ends" from="AB" to="BC" begin="0" end="400" period="9"/>
<personFlow id="walkers" begin="0" period="9"><walk from="AB" to="BC"/></personFlow>)"),
            "open counted ends walkers");
  EXPECT_EQ(copy.at(0).value_or("end", ""), "300.00");
  EXPECT_EQ(copy.at(1).value_or("end", "none"), "none");
  EXPECT_EQ(copy.at(2).value_or("end", ""), "400");
  EXPECT_EQ(copy.at(3).value_or("end", ""), "300.00");
}

TEST_F(Scan, AFlowMayHaveTheIdOfAVehicle) {
  const std::string trip = R"(<trip id="7" from="AB" to="BC" depart="0" via="AB"/>)";
  const std::string flow = R"(<flow id="7" from="AB" to="BC" begin="0" end="9" number="2" via="BC"/>)";
  EXPECT_EQ(left_of(trip + flow), "7 7") << "SUMO names the flow's vehicles 7.0 and 7.1";
  EXPECT_EQ(scan.via.at("7"), "AB");
  EXPECT_EQ(scan.via_of_flows.at("7"), "BC");
  EXPECT_NE(input_error([&] { left_of(trip); }).find("<trip id='7'>: there is a vehicle or trip of this id"),
            std::string::npos);
  EXPECT_NE(input_error([&] { left_of(flow); }).find("<flow id='7'>: there is a flow of this id already"),
            std::string::npos);
}

TEST_F(Scan, TypesOfIncludedFilesAreFound) {
  folder.write("sub/inner.add.xml", R"(<additional><vType id="lorry" vClass="truck"/></additional>)");
  const auto outer = folder.write("outer.add.xml", R"(<additional><include href="sub/inner.add.xml"/>
      <vType id="car"/></additional>)");
  TypeClasses types;
  read_types(outer, types);
  ASSERT_EQ(types.size(), 2U);
  EXPECT_EQ(types.at("lorry"), VehicleClass::truck);
}

}  // namespace
}  // namespace thalweg::testing
