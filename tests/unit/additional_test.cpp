// SPDX-License-Identifier: Apache-2.0
#include "demand/additional.hpp"

#include <gtest/gtest.h>

#include "support/input_error.hpp"
#include "support/temporary_folder.hpp"
#include "xml/node.hpp"

namespace thalweg::testing {
namespace {

namespace fs = std::filesystem;

class Additional : public ::testing::Test {
 protected:
  /// The elements below the root of the copy of an additional file with this content.
  std::vector<xml::Node> copy_of(const std::string& content) {
    const auto from = folder.write("city/extra.add.xml", "<additional>\n" + content + "\n</additional>");
    rewrite_additional(from, folder / "run/extra.add.xml", places, false);
    return elements_of(folder / "run/extra.add.xml");
  }
  static std::vector<xml::Node> elements_of(const fs::path& file) {
    std::vector<xml::Node> nodes;
    xml::read_nodes(
        file, [](const xml::Element&) {}, [&](xml::Node& node) { nodes.push_back(node); });
    return nodes;
  }
  [[nodiscard]] std::string in_city(const std::string& name) const {
    return (folder / "city" / name).string();
  }
  [[nodiscard]] std::string in_run(const std::string& name) const { return (folder / "run" / name).string(); }
  static std::string attribute(const xml::Node& node, std::string_view name) {
    return std::string(node.value_or(name, "(none)"));
  }

  void SetUp() override { fs::create_directories(folder / "run"); }

  TemporaryFolder folder;
  OutputPlaces places{folder / "run", ""};
};

TEST_F(Additional, OutputsLandInTheRunsFolder) {
  const auto nodes = copy_of(R"(
<e1Detector id="a" lane="l_0" pos="1" file="e1.xml"/>
<laneAreaDetector id="b" lane="l_0" file="sub/e2.xml"/>
<entryExitDetector id="c" file="e3.xml"><detEntry lane="l_0" pos="1"/></entryExitDetector>
<edgeData id="d" file="../edges.xml"/>
<laneData id="e" file="/elsewhere/lanes.xml"/>
<timedEvent type="SaveTLSStates" source="0" dest="states.xml"/>
<calibrator id="f" edge="e" output="calibrator.xml"/>
<tlLogic id="t"><param key="file" value="signal.xml"/><param key="show-detectors" value="x"/></tlLogic>
<vType id="v"><param key="device.ssm.file" value="ssm.xml"/></vType>)");
  ASSERT_EQ(nodes.size(), 9U);
  EXPECT_EQ(attribute(nodes[0], "file"), in_run("e1.xml"));
  EXPECT_EQ(attribute(nodes[0], "lane"), "l_0") << "all else is as it was";
  EXPECT_EQ(attribute(nodes[1], "file"), in_run("sub/e2.xml"));
  EXPECT_TRUE(fs::is_directory(folder / "run/sub")) << "SUMO makes no folders";
  EXPECT_EQ(attribute(nodes[2], "file"), in_run("e3.xml"));
  EXPECT_EQ(nodes[2].children.size(), 1U);
  EXPECT_EQ(attribute(nodes[3], "file"), in_run("edges.xml")) << "nothing leads out of the run's folder";
  EXPECT_EQ(attribute(nodes[4], "file"), in_run("lanes.xml"));
  EXPECT_EQ(attribute(nodes[5], "dest"), in_run("states.xml"));
  EXPECT_EQ(attribute(nodes[6], "output"), in_run("calibrator.xml"));
  EXPECT_EQ(attribute(nodes[7].children.at(0), "value"), in_run("signal.xml"));
  EXPECT_EQ(attribute(nodes[7].children.at(1), "value"), "x");
  EXPECT_EQ(attribute(nodes[8].children.at(0), "value"), in_run("ssm.xml"));
}

TEST_F(Additional, SpecialNamesStay) {
  const auto nodes = copy_of(R"(
<e1Detector id="a" file="NUL"/><e1Detector id="b" file="-"/><e1Detector id="c" file="localhost:8000"/>
<e1Detector id="d" file=""/><e1Detector id="e" file="/dev/null"/><e1Detector id="f" file="stdout"/>)");
  std::string files;
  for (const auto& node : nodes) files += attribute(node, "file") + " ";
  EXPECT_EQ(files, "NUL - localhost:8000  /dev/null stdout ");
}

TEST_F(Additional, InputsAreFoundFromAnywhere) {
  const auto nodes = copy_of(R"(
<poly id="p" imgFile="../map.png"/>
<rerouter id="r" edges="e" file="closing.xml"/>
<variableSpeedSign id="s" lanes="l" file="/abs/speeds.xml"/>)");
  ASSERT_EQ(nodes.size(), 3U);
  EXPECT_EQ(attribute(nodes[0], "imgFile"), (folder / "map.png").string());
  EXPECT_EQ(attribute(nodes[1], "file"), in_city("closing.xml"));
  EXPECT_EQ(attribute(nodes[2], "file"), "/abs/speeds.xml");
}

TEST_F(Additional, DemandIsLeftOutButForItsTypesAndRoutes) {
  const auto nodes = copy_of(R"(
<trip id="t" from="a" to="b" depart="0"/><vehicle id="v" depart="0"><route edges="a b"/></vehicle>
<flow id="f" from="a" to="b"/><person id="p" depart="0"/><personFlow id="q"/><container id="c"/>
<busStop id="s" lane="l_0"/><vType id="t"/><route id="r" edges="a b"/>)");
  std::string left;
  for (const auto& node : nodes) left += node.name + " ";
  EXPECT_EQ(left, "busStop vType route ");
}

TEST_F(Additional, NothingSwitchesSumosRouterOn) {
  const auto nodes = copy_of(R"(
<vTypeDistribution id="d"><vType id="c">
  <param key="has.rerouting.device" value="true"/><param key="device.rerouting.period" value="1"/>
  <param key="keep" value="1"/>
</vType></vTypeDistribution>)");
  ASSERT_EQ(nodes.size(), 1U);
  const auto& params = nodes[0].children.at(0).children;
  ASSERT_EQ(params.size(), 1U);
  EXPECT_EQ(attribute(params[0], "key"), "keep");
  EXPECT_TRUE(switches_rerouting("device.rerouting.probability"));
  EXPECT_FALSE(switches_rerouting("device.reroutings"));
  EXPECT_FALSE(switches_rerouting("has.emissions.device"));
}

TEST_F(Additional, IncludedFilesAreCopiedToo) {
  folder.write("city/sub/inner.add.xml", "<additional><e1Detector id='i' file='e1.xml'/></additional>");
  const auto nodes = copy_of("<include href=\"sub/inner.add.xml\"/>\n<e1Detector id=\"o\" file=\"e1.xml\"/>");
  ASSERT_EQ(nodes.size(), 2U);
  const auto inner = elements_of(attribute(nodes[0], "href"));
  ASSERT_EQ(inner.size(), 1U);
  const std::string first = attribute(inner[0], "file");
  const std::string second = attribute(nodes[1], "file");
  EXPECT_EQ(first, in_run("e1.xml"));
  EXPECT_EQ(second, in_run("2-e1.xml")) << "the user had two files of this name in two folders";
}

TEST_F(Additional, ErrorsNameTheFileAndLeaveNoCopy) {
  const auto from = folder.write("city/bad.add.xml", "<additional>\n<include/>\n</additional>");
  const auto to = folder / "run/bad.add.xml";
  EXPECT_TRUE(contains(input_error([&] { rewrite_additional(from, to, places, false); }),
                       from.string() + ":2: <include>: the attribute 'href' is missing"));
  EXPECT_TRUE(fs::is_empty(folder / "run"));
}

TEST_F(Additional, AFileThatIncludesItselfIsTold) {
  const auto from = folder.write("city/a.add.xml", "<additional><include href=\"b.add.xml\"/></additional>");
  folder.write("city/b.add.xml", "<additional><include href=\"./a.add.xml\"/></additional>");
  const auto copy = [&] { rewrite_additional(from, folder / "run/a.add.xml", places, false); };
  EXPECT_TRUE(contains(input_error(copy), "a.add.xml includes itself"));
}

TEST_F(Additional, TheUsersFolderStaysAsItWas) {
  copy_of("<e1Detector id=\"a\" file=\"sub/e1.xml\"/>");
  EXPECT_EQ(folder.files(), (std::vector<std::string>{"city/extra.add.xml", "run/extra.add.xml"}));
  EXPECT_FALSE(fs::exists(folder / "city/sub"));
}

TEST(OutputPlaces, TheSuffixIsBeforeTheExtension) {
  const TemporaryFolder folder;
  OutputPlaces places(folder.path(), "p-", "-s");
  EXPECT_EQ(places.place("out.xml", "/a"), folder / "p-out-s.xml");
  EXPECT_EQ(places.place("out.xml.gz", "/a"), folder / "p-out-s.xml.gz");
  EXPECT_EQ(places.place("sub.d/out", "/a"), folder / "sub.d/p-out-s");
  EXPECT_EQ(places.place(".gz", "/a"), folder / "p--s.gz");
}

TEST(OutputPlaces, EachFileOfTheUsersHasAPlaceOfItsOwn) {
  const TemporaryFolder folder;
  OutputPlaces places(folder.path(), "s1-");
  const auto in = [&](const char* name) { return (folder / name).string(); };
  EXPECT_EQ(places.place("out.xml", "/a"), in("s1-out.xml"));
  EXPECT_EQ(places.place("out.xml", "/a"), in("s1-out.xml")) << "the same file";
  EXPECT_EQ(places.place("../a/out.xml", "/a"), in("s1-out.xml")) << "the same file, called otherwise";
  EXPECT_EQ(places.place("out.xml", "/b"), in("2-s1-out.xml"));
  EXPECT_EQ(places.place("/c/out.xml", "/b"), in("3-s1-out.xml"));
  EXPECT_EQ(places.place("out.xml", "/b"), in("2-s1-out.xml"));
  EXPECT_EQ(places.place("sub/out.xml", "/a"), in("sub/s1-out.xml"));
  EXPECT_EQ(places.place("a/../other.xml", "/a"), in("s1-other.xml"));
}

}  // namespace
}  // namespace thalweg::testing
