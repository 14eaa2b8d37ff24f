// SPDX-License-Identifier: Apache-2.0
#include "network/lane_changes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/ascii_network.hpp"
#include "support/input_error.hpp"
#include "support/temporary_folder.hpp"

namespace thalweg::testing {
namespace {

//     A---B---C      one lane each, AB_0 and so on
class LaneChanges : public ::testing::Test {
 protected:
  /// "lane begin-end what" of every change in an additional file with this content.
  std::vector<std::string> changes_in(const std::string& content) {
    const auto file = folder.write("city/extra.add.xml", "<additional>" + content + "</additional>");
    std::vector<std::string> lines;
    for (const LaneChange& change : read_lane_changes(std::vector{file.string()}, net)) {
      std::string what = change.speed ? fmt::format("{} m/s", *change.speed) : "for";
      if (!change.speed) {
        for (const VehicleClass c : {VehicleClass::passenger, VehicleClass::bus})
          what += change.permissions.allows(c) ? (c == VehicleClass::bus ? " bus" : " passenger") : "";
      }
      if (!change.enforced) what += ", SUMO's device not told";
      const std::string end = change.end == infinity ? "" : std::to_string(change.end / 1000);
      lines.push_back(fmt::format("{} {}-{} {}", net.roads[net.lanes[change.lane].road].id,
                                  change.begin / 1000, end, what));
    }
    return lines;
  }

  using Lines = std::vector<std::string>;
  Network net = ascii_network("A---B---C");
  TemporaryFolder folder;
};

TEST_F(LaneChanges, ClosingsOfRerouters) {
  EXPECT_EQ(changes_in(R"(
      <rerouter id="r" edges="AB">
        <interval begin="60" end="0:02:00"><closingReroute id="BC"/></interval>
        <interval begin="300" end="400"><closingReroute id="BC" allow="bus"/></interval>
        <interval end="30"><closingReroute id="BC" disallow="bus"/><closingLaneReroute id="AB_0"/></interval>
        <interval begin="500"><destProbReroute id="BC"/></interval>
      </rerouter>)"),
            (Lines{"BC 60-120 for, SUMO's device not told", "BC 300-400 for bus", "BC 0-30 for passenger",
                   "AB 0-30 for"}));
}

TEST_F(LaneChanges, StepsOfSpeedSigns) {
  EXPECT_EQ(changes_in(R"(
      <variableSpeedSign id="s" lanes="AB_0 BC_0">
        <step time="10" speed="2.5"/><step time="0:01:00" speed="-1"/><step time="90" speed="5"/>
      </variableSpeedSign>)"),
            (Lines{"AB 10-60 2.5 m/s", "AB 90- 5 m/s", "BC 10-60 2.5 m/s", "BC 90- 5 m/s"}));
}

TEST_F(LaneChanges, OtherFilesAreFollowed) {
  folder.write("city/more/signs.xml", "<vss><step time=\"0\" speed=\"1\"/></vss>");
  folder.write("city/more/included.xml",
               "<additional><variableSpeedSign id=\"t\" lanes=\"AB_0\" file=\"signs.xml\"/></additional>");
  folder.write("city/times.xml",
               "<r><interval begin=\"1\" end=\"2\"><closingReroute id=\"AB\"/></interval></r>");
  EXPECT_EQ(
      changes_in(R"(<include href="more/included.xml"/><rerouter id="r" edges="AB" file="times.xml"/>)"),
      (Lines{"AB 0- 1 m/s", "AB 1-2 for, SUMO's device not told"}));
}

TEST_F(LaneChanges, WhatDoesNotConcernEverybodyIsLeftOut) {
  EXPECT_EQ(changes_in(R"(
      <rerouter id="off" edges="AB" off="true"><interval><closingReroute id="BC"/></interval></rerouter>
      <rerouter id="some" edges="AB" vTypes="truck"><interval><closingReroute id="BC"/></interval></rerouter>
      <rerouter id="away" edges="AB"><interval><closingReroute id="XY"/><closingLaneReroute id="AB_7"/>
      </interval></rerouter>)"),
            Lines{});
}

TEST_F(LaneChanges, AFileThatIsMissingIsAnError) {
  const auto read = [&] { changes_in(R"(<rerouter id="r" edges="AB" file="none.xml"/>)"); };
  EXPECT_TRUE(contains(input_error(read), "none.xml"));
}

}  // namespace
}  // namespace thalweg::testing
