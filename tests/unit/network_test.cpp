// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "network/read_network.hpp"
#include "support/ascii_network.hpp"
#include "support/input_error.hpp"
#include "support/temporary_folder.hpp"

namespace thalweg::testing {
namespace {

/// A net of one road AB between two junctions, with a lane `lane` beside its id, and `rest` after them. Each
/// part has a line of its own: lane 3, junctions 5 and 6, rest 7.
std::string small_net(const std::string& lane, const std::string& rest = "") {
  return fmt::format(
      "<net>\n"
      "<edge id=\"AB\" from=\"A\" to=\"B\">\n"
      "<lane id=\"AB_0\" index=\"0\" {}/>\n"
      "</edge>\n"
      "<junction id=\"A\" type=\"dead_end\" x=\"0\" y=\"0\"/>\n"
      "<junction id=\"B\" type=\"dead_end\" x=\"100\" y=\"0\"/>\n"
      "{}\n"
      "</net>\n",
      lane, rest);
}
const std::string good_lane = "length=\"100\" speed=\"10\"";

std::string error_of(const std::string& text) {
  return input_error([&] { parse_network(text); });
}

//     A ==2 lanes==> B --> C      one signal at B, an internal road for each lane of AB
constexpr const char* full_net = R"(<net version="1.20" lefthand="true">
<location netOffset="-5.5,7" convBoundary="0,0,200,0" origBoundary="1,2,3,4" projParameter="+proj=utm +zone=32"/>
<type id="highway.residential"><restriction vClass="bicycle" speed="4.5"/></type>
<edge id=":B_0" function="internal">
  <lane id=":B_0_0" index="0" speed="6.5" length="12.25"/>
</edge>
<edge id=":B_w0" function="walkingarea"><lane id=":B_w0_0" index="0" speed="1" length="1" allow="pedestrian"/></edge>
<edge id=":B_c0" function="crossing"><lane id=":B_c0_0" index="0" speed="1" length="1" allow="pedestrian"/></edge>
<edge id="AB" from="A" to="B" priority="7" name="Am &amp; Markt" type="highway.residential" shape="0,0 50,1,2 100,0">
  <lane id="AB_0" index="0" allow="pedestrian bicycle" speed="13.89" length="100.5" shape="0,-2 100,-2"/>
  <lane id="AB_1" index="1" disallow="pedestrian tram" speed="13.89" length="99.5" changeLeft="bus" changeRight="emergency passenger"/>
</edge>
<edge id="BC" from="B" to="C"><lane id="BC_0" index="0" speed="10" length="50"/></edge>
<tlLogic id="B" type="actuated" programID="day" offset="5">
  <phase duration="31" state="Gr"/><phase duration="3.5" state="yr"/>
</tlLogic>
<tlLogic id="B" type="static" programID="night" offset="0"><phase duration="90" state="oo"/></tlLogic>
<junction id="A" type="dead_end" x="0" y="0"/>
<junction id="B" type="traffic_light" x="100" y="0.5" z="3" shape="98,0 102,0 100,2"/>
<junction id="C" type="dead_end" x="150" y="0"/>
<junction id=":B_0_0" type="internal" x="1" y="1"/>
<connection from="AB" to="BC" fromLane="1" toLane="0" via=":B_0_0" tl="B" linkIndex="1" dir="l" state="o" disallow="truck"/>
<connection from="AB" to="BC" fromLane="0" toLane="0" dir="R" state="m"/>
<connection from=":B_0" to="BC" fromLane="0" toLane="0"/>
<roundabout nodes="A B" edges="AB BC"/>
</net>)";

TEST(Network, ReadsRoadsAndLanes) {
  const Network net = parse_network(full_net);
  ASSERT_EQ(net.roads.size(), 5U);
  ASSERT_EQ(net.lanes.size(), 6U);
  EXPECT_TRUE(net.left_hand);
  EXPECT_TRUE(net.warnings.empty());
  const Road& ab = net.roads[road(net, "AB")];
  EXPECT_EQ(ab.function, RoadFunction::normal);
  EXPECT_EQ(net.junctions[ab.from].id, "A");
  EXPECT_EQ(net.junctions[ab.to].id, "B");
  EXPECT_EQ(ab.priority, 7);
  EXPECT_EQ(ab.name, "Am & Markt");
  EXPECT_EQ(ab.type, "highway.residential");
  ASSERT_EQ(ab.shape.size(), 3U);
  EXPECT_EQ(ab.shape[1].x, 50);
  EXPECT_EQ(ab.shape[1].y, 1);
  EXPECT_EQ(ab.shape[1].z, 2);
  ASSERT_EQ(ab.lane_count, 2U);
  const Lane& kerb = net.lanes[ab.first_lane];
  EXPECT_EQ(kerb.road, road(net, "AB"));
  EXPECT_EQ(kerb.length, 100.5);
  EXPECT_EQ(kerb.speed, 13.89);
  ASSERT_EQ(kerb.shape.size(), 2U);
  EXPECT_EQ(kerb.shape[0].y, -2);
  EXPECT_EQ(net.lanes[ab.lane(1)].length, 99.5);
  std::vector<LaneId> lanes;
  for (const LaneId lane : ab.lanes()) lanes.push_back(lane);
  EXPECT_EQ(lanes, (std::vector<LaneId>{ab.first_lane, ab.lane(1)}));
  EXPECT_EQ(net.find_road("CB"), std::nullopt);
}

TEST(Network, ReadsInternalRoads) {
  const Network net = parse_network(full_net);
  const Road& internal = net.roads[road(net, ":B_0")];
  EXPECT_EQ(internal.function, RoadFunction::internal);
  EXPECT_FALSE(internal.from.valid());
  EXPECT_EQ(net.lanes[internal.first_lane].length, 12.25);
  EXPECT_EQ(net.lanes[internal.first_lane].speed, 6.5);
  EXPECT_EQ(net.roads[road(net, ":B_w0")].function, RoadFunction::walking_area);
  EXPECT_EQ(net.roads[road(net, ":B_c0")].function, RoadFunction::crossing);
}

TEST(Network, ReadsPermissions) {
  using enum VehicleClass;
  const Network net = parse_network(full_net);
  const LaneId first = net.roads[road(net, "AB")].first_lane;
  const Permissions allowed = net.lanes[first].permissions;
  EXPECT_TRUE(allowed.allows(bicycle));
  EXPECT_FALSE(allowed.allows(passenger));
  EXPECT_TRUE(allowed.allows(ignoring));
  const Lane& inner = net.lanes[LaneId{first.value + 1U}];
  EXPECT_FALSE(inner.permissions.allows(tram));
  EXPECT_TRUE(inner.permissions.allows(passenger));
  EXPECT_TRUE(inner.change_left.allows(bus));
  EXPECT_FALSE(inner.change_left.allows(passenger));
  EXPECT_TRUE(inner.change_right.allows(emergency));
  EXPECT_FALSE(inner.change_right.allows(bus));
  EXPECT_EQ(net.lanes[first].change_left, Permissions::all());
}

TEST(Network, ReadsConnections) {
  const Network net = parse_network(full_net);
  ASSERT_EQ(net.connections.size(), 3U);
  const Connection& left = net.connections[ConnectionId{0U}];
  EXPECT_EQ(left.from, road(net, "AB"));
  EXPECT_EQ(left.to, road(net, "BC"));
  EXPECT_EQ(left.from_lane, 1U);
  EXPECT_EQ(left.to_lane, 0U);
  EXPECT_EQ(net.lanes[left.via].road, road(net, ":B_0"));
  EXPECT_EQ(left.direction, 'l');
  EXPECT_EQ(left.state, 'o');
  EXPECT_EQ(net.signals[left.signal].id, "B");
  EXPECT_EQ(left.link_index, 1);
  EXPECT_FALSE(left.permissions.allows(VehicleClass::truck));
  const Connection& right = net.connections[ConnectionId{1U}];
  EXPECT_FALSE(right.via.valid());
  EXPECT_FALSE(right.signal.valid());
  EXPECT_EQ(right.direction, 'R');
  EXPECT_EQ(right.state, 'm');
}

TEST(Network, ReadsSignalProgrammes) {
  const Network net = parse_network(full_net);
  ASSERT_EQ(net.signals.size(), 1U);
  const Signal& signal = net.signals[SignalId{0U}];
  ASSERT_EQ(signal.programmes.size(), 2U);
  EXPECT_EQ(signal.programmes[0].id, "day");
  EXPECT_EQ(signal.programmes[0].type, "actuated");
  EXPECT_EQ(signal.programmes[0].offset, 5'000);
  ASSERT_EQ(signal.programmes[0].phases.size(), 2U);
  EXPECT_EQ(signal.programmes[0].phases[1].duration, 3'500);
  EXPECT_EQ(signal.programmes[0].phases[1].state, "yr");
  EXPECT_EQ(signal.programmes[1].phases.size(), 1U);
}

TEST(Network, ReadsJunctionsRoundaboutsLocationAndRestrictions) {
  const Network net = parse_network(full_net);
  ASSERT_EQ(net.junctions.size(), 3U) << "internal junctions are no junctions of the net";
  const Junction& b = net.junctions[net.roads[road(net, "AB")].to];
  EXPECT_EQ(b.type, "traffic_light");
  EXPECT_EQ(b.position.x, 100);
  EXPECT_EQ(b.position.y, 0.5);
  EXPECT_EQ(b.position.z, 3);
  EXPECT_EQ(b.shape.size(), 3U);
  ASSERT_EQ(net.roundabouts.size(), 1U);
  EXPECT_EQ(net.roundabouts[0].roads, (std::vector{road(net, "AB"), road(net, "BC")}));
  EXPECT_EQ(net.roundabouts[0].junctions.size(), 2U);
  EXPECT_EQ(net.location.net_offset.x, -5.5);
  EXPECT_EQ(net.location.net_offset.y, 7);
  EXPECT_EQ(net.location.projection, "+proj=utm +zone=32");
  EXPECT_EQ(net.location.converted_boundary, "0,0,200,0");
  EXPECT_EQ(net.location.original_boundary, "1,2,3,4");
  ASSERT_EQ(net.restrictions.size(), 1U);
  EXPECT_EQ(net.restrictions[0].type, "highway.residential");
  EXPECT_EQ(net.restrictions[0].vehicle_class, VehicleClass::bicycle);
  EXPECT_EQ(net.restrictions[0].speed, 4.5);
}

TEST(Network, UnknownClassIsOneWarningAndIsLeftOut) {
  const std::string lane = good_lane + " allow=\"hovercraft bus\"";
  const std::string more =
      "<edge id=\"BA\" from=\"B\" to=\"A\"><lane id=\"BA_0\" length=\"1\" speed=\"1\" "
      "disallow=\"hovercraft bus\"/></edge>";
  const Network net = parse_network(small_net(lane, more));
  ASSERT_EQ(net.warnings.size(), 1U);
  EXPECT_TRUE(contains(net.warnings[0], "(text):3: <lane id='AB_0'>: the vehicle class 'hovercraft'"));
  const auto permissions = [&](const char* id) {
    return net.lanes[net.roads[road(net, id)].first_lane].permissions;
  };
  EXPECT_TRUE(permissions("AB").allows(VehicleClass::bus));
  EXPECT_FALSE(permissions("AB").allows(VehicleClass::passenger));
  EXPECT_FALSE(permissions("BA").allows(VehicleClass::bus));
  EXPECT_TRUE(permissions("BA").allows(VehicleClass::passenger));
}

TEST(Network, PermissionWords) {
  using enum VehicleClass;
  std::vector<std::string> unknown;
  const auto allow = [&](const char* list) { return parse_permissions(list, std::nullopt, unknown); };
  EXPECT_EQ(allow("all"), Permissions::all());
  EXPECT_EQ(allow("none"), Permissions::none());
  EXPECT_TRUE(allow("rail_slow").allows(rail)) << "names of old nets";
  EXPECT_EQ(parse_permissions(std::nullopt, "all", unknown), Permissions::none());
  EXPECT_EQ(parse_permissions("", "bus", unknown), parse_permissions(std::nullopt, "bus", unknown));
  EXPECT_TRUE(parse_permissions("bus", "bus", unknown).allows(bus)) << "allow comes before disallow";
  EXPECT_TRUE(unknown.empty());
}

struct BadNet {
  const char* name;
  std::string text;
  std::string message;  ///< a part of it
  friend std::ostream& operator<<(std::ostream& out, const BadNet& bad) { return out << bad.name; }
};

class BadNetwork : public ::testing::TestWithParam<BadNet> {};

TEST_P(BadNetwork, IsRefusedWithPlaceAndElement) {
  EXPECT_TRUE(contains(error_of(GetParam().text), GetParam().message));
}

std::string connection(const std::string& attributes) {
  return small_net(good_lane, "<connection " + attributes + "/>");
}

/// Longer than libxml2 lets an attribute be.
std::string long_text() {
  std::string text;
  text.resize(11'000'000, '1');
  return text;
}

std::vector<BadNet> bad_nets() {
  const std::string lane = "(text):3: <lane id='AB_0'>: ";
  const std::string link = "(text):7: <connection>: ";
  return {
      {"LaneWithoutLength", small_net("speed=\"10\""), lane + "the attribute 'length' is missing"},
      {"NegativeLength", small_net("length=\"-1\" speed=\"10\""), lane + "length='-1' is negative"},
      {"NanLength", small_net("length=\"NaN\" speed=\"10\""), lane + "length='NaN' is not a number"},
      {"LaneWithoutSpeed", small_net("length=\"1\""), lane + "the attribute 'speed' is missing"},
      {"NegativeSpeed", small_net("length=\"1\" speed=\"-0.5\""), lane + "speed='-0.5' is negative"},
      {"NanSpeed", small_net("length=\"1\" speed=\"nan\""), lane + "speed='nan' is not a number"},
      {"InfiniteSpeed", small_net("length=\"1\" speed=\"inf\""), lane + "speed='inf' is not a number"},
      {"SpeedWithUnit", small_net("length=\"1\" speed=\"10 m/s\""), lane + "speed='10 m/s' is not a number"},
      {"ShapeIsNoPoint", small_net(good_lane + " shape=\"1,2 3\""), lane + "shape: '3' is not a point"},
      {"ConnectionFromUnknownRoad", connection("from=\"XY\" to=\"AB\" fromLane=\"0\" toLane=\"0\""),
       link + "from='XY' is no edge of this net"},
      {"ConnectionToUnknownRoad", connection("from=\"AB\" to=\"XY\" fromLane=\"0\" toLane=\"0\""),
       link + "to='XY' is no edge of this net"},
      {"ConnectionFromUnknownLane", connection("from=\"AB\" to=\"AB\" fromLane=\"1\" toLane=\"0\""),
       link + "fromLane='1': the edge 'AB' has 1 lanes"},
      {"ConnectionToNegativeLane", connection("from=\"AB\" to=\"AB\" fromLane=\"0\" toLane=\"-1\""),
       link + "toLane='-1': the edge 'AB' has 1 lanes"},
      {"ConnectionWithoutLane", connection("from=\"AB\" to=\"AB\" toLane=\"0\""),
       link + "the attribute 'fromLane' is missing"},
      {"ConnectionByUnknownVia",
       connection("from=\"AB\" to=\"AB\" fromLane=\"0\" toLane=\"0\" via=\":B_9_0\""),
       link + "via=':B_9_0' is no lane of this net"},
      {"EdgeTwice",
       small_net(good_lane,
                 "<edge id=\"AB\" from=\"A\" to=\"B\"><lane id=\"x\" length=\"1\" speed=\"1\"/></edge>"),
       "(text):7: <edge id='AB'>: there is an edge of this id already"},
      {"LaneTwice",
       small_net(good_lane,
                 "<edge id=\"BA\" from=\"B\" to=\"A\"><lane id=\"AB_0\" length=\"1\" speed=\"1\"/></edge>"),
       "(text):7: <lane id='AB_0'>: there is a lane of this id already"},
      {"JunctionTwice", small_net(good_lane, "<junction id=\"A\" x=\"0\" y=\"0\"/>"),
       "(text):7: <junction id='A'>: there is a junction of this id already"},
      {"EdgeWithoutLanes", small_net(good_lane, "<edge id=\"BA\" from=\"B\" to=\"A\"/>"),
       "(text):7: <edge id='BA'>: the edge has no lanes"},
      {"EdgeOfUnknownFunction", small_net(good_lane, "<edge id=\"BA\" function=\"tunnel\"/>"),
       "(text):7: <edge id='BA'>: function='tunnel' is unknown"},
      {"EdgeToUnknownJunction",
       small_net(good_lane,
                 "<edge id=\"BC\" from=\"B\" to=\"C\"><lane id=\"BC_0\" length=\"1\" speed=\"1\"/></edge>"),
       "(text):7: <edge id='BC'>: the junction 'C' is not in the net"},
      {"LaneOutsideOfAnEdge", small_net(good_lane, "<lane id=\"x\" length=\"1\" speed=\"1\"/>"),
       "(text):7: <lane id='x'>: a lane outside of an edge"},
      {"JunctionWithoutPlace", small_net(good_lane, "<junction id=\"C\" x=\"0\"/>"),
       "(text):7: <junction id='C'>: the attribute 'y' is missing"},
      {"PhaseWithoutProgramme", small_net(good_lane, "<phase duration=\"1\" state=\"G\"/>"),
       "(text):7: <phase>: a phase outside of a signal programme"},
      {"RoundaboutOfUnknownEdges", small_net(good_lane, "<roundabout nodes=\"A\" edges=\"XY\"/>"),
       "(text):7: <roundabout>: edges: 'XY' is no edge of this net"},
      {"NetOffsetIsNoPoint", small_net(good_lane, "<location netOffset=\"1\"/>"),
       "(text):7: <location>: netOffset is not a point"},
      {"NotANet", "<?xml version=\"1.0\"?>\n<routes/>", "(text):2: <routes>: this is no SUMO network"},
      {"Empty", "", "(text):1: not well-formed XML"},
      {"NoXml", "junction A", "(text):1: not well-formed XML"},
      {"CutShort", small_net(good_lane).substr(0, 120),
       "(text):5: not well-formed XML: AttValue: ' expected"},
      {"DocumentType", "<!DOCTYPE net SYSTEM \"file:///etc/hostname\">\n<net/>", "(text):1: <!DOCTYPE>"},
      {"EntityExpansion", "<!DOCTYPE net [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;&a;&a;\">]>\n<net>&b;</net>",
       "(text):1: <!DOCTYPE>"},
      {"EntityNobodyKnows", small_net(good_lane + " type=\"&a;\""), "(text):3: not well-formed XML"},
      {"HugeAttribute", small_net(good_lane + " shape=\"" + long_text() + "\""),
       "(text):3: not well-formed XML: AttValue length too long"},
      {"DeepNesting",
       [] {
         std::string text = "<net>";
         for (int i = 0; i < 100'000; ++i) text += "<param>";
         return text;
       }(),
       "(text):1: not well-formed XML: Excessive depth"},
  };
}

INSTANTIATE_TEST_SUITE_P(Network, BadNetwork, ::testing::ValuesIn(bad_nets()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(Network, SmallNetIsGood) {  // or the bad ones above would be bad for another reason
  EXPECT_EQ(parse_network(small_net(good_lane)).roads.size(), 1U);
  EXPECT_EQ(parse_network(connection("from=\"AB\" to=\"AB\" fromLane=\"0\" toLane=\"0\"")).connections.size(),
            1U);
}

TEST(Network, ReadsAFilePlainAndCompressedAlike) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_network(folder.write("a.net.xml", full_net)).roads.size(), 5U);
  EXPECT_EQ(read_network(folder.write_gzip("a.net.xml.gz", full_net)).roads.size(), 5U);
}

TEST(Network, ErrorsNameTheFile) {
  const TemporaryFolder folder;
  const auto missing = folder / "none.net.xml";
  EXPECT_TRUE(
      contains(input_error([&] { read_network(missing); }), "cannot read '" + missing.string() + "'"));
  const auto bad = folder.write("bad.net.xml", small_net("speed=\"10\""));
  EXPECT_TRUE(contains(input_error([&] { read_network(bad); }), bad.string() + ":3: <lane id='AB_0'>"));
  const auto dangling = folder.write("dangling.net.xml",
                                     "<net>\n<edge id=\"AB\" from=\"A\" to=\"B\">\n"
                                     "<lane id=\"AB_0\" length=\"1\" speed=\"1\"/></edge></net>");
  EXPECT_TRUE(
      contains(input_error([&] { read_network(dangling); }), dangling.string() + ":2: <edge id='AB'>"));
}

//     A--B->C
//     |     |
//     D-----E
TEST(AsciiNetwork, IsTheDrawing) {
  const Network net = ascii_network("A--B->C\n|     |\nD-----E");
  EXPECT_EQ(net.junctions.size(), 5U);
  EXPECT_EQ(net.roads.size(), 9U);
  EXPECT_EQ(net.find_road("CB"), std::nullopt) << "one way";
  EXPECT_EQ(net.lanes[net.roads[road(net, "AB")].first_lane].length, 200);
  EXPECT_EQ(net.lanes[net.roads[road(net, "CE")].first_lane].length, 100);
  EXPECT_EQ(net.lanes[net.roads[road(net, "ED")].first_lane].length, 500);
  EXPECT_EQ(net.connections.size(), 9U - 1U) << "AB BA BC AD DA CE EC DE ED: each leads on, but for EC";
  EXPECT_THROW(ascii_network("A--"), std::invalid_argument);
  EXPECT_THROW(ascii_network("A-A"), std::invalid_argument);
}

}  // namespace
}  // namespace thalweg::testing
