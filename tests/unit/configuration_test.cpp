// SPDX-License-Identifier: Apache-2.0
#include "sumo/configuration.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/input_error.hpp"
#include "support/temporary_folder.hpp"

namespace thalweg::testing {
namespace {

std::string text_of(const std::vector<Setting>& settings) {
  std::string text;
  for (const auto& [name, value] : settings) text += fmt::format("{}={}\n", name, value);
  return text;
}

TEST(Configuration, AnyRootAndAnySectionsInTheirOrder) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.sumocfg", R"(<sumoConfiguration xmlns:xsi="http://x">
  <!-- a comment -->
  <input><net-file value="a &amp; b.net.xml"/><route-files v="r1.xml,r2.xml"/></input>
  <my-own-section><deep><begin value="5"/></deep></my-own-section>
  <end value="10"/>
  <no-value/>
</sumoConfiguration>)");
  EXPECT_EQ(text_of(read_configuration(file)),
            "net-file=a & b.net.xml\nroute-files=r1.xml,r2.xml\nbegin=5\nend=10\n");
}

TEST(Configuration, VariablesOfTheEnvironmentAreFilledIn) {
  const TemporaryFolder folder;
  setenv("THALWEG_TEST_CITY", "bologna", 1);
  const auto file = folder.write("a.sumocfg", R"(<configuration>
  <net-file value="${THALWEG_TEST_CITY}/${THALWEG_TEST_CITY}.net.xml"/><route-files value="a${THALWEG_NOBODY}.xml"/>
  <log value="${LOCALTIME}-${UTC}-${PID}.log"/><output-prefix value="$5 ${ {} ${open"/></configuration>)");
  EXPECT_EQ(text_of(read_configuration(file)),
            "net-file=bologna/bologna.net.xml\nroute-files=a.xml\nlog=${LOCALTIME}-${UTC}-${PID}.log\n"
            "output-prefix=$5  ${open\n");
}

TEST(Configuration, ComesBackAsItWasWritten) {
  const TemporaryFolder folder;
  const std::vector<Setting> settings{{"net-file", "<&\">.xml"}, {"empty", ""}, {"begin", "5"}};
  write_configuration(folder / "a.sumocfg", "for a test", settings);
  EXPECT_EQ(text_of(read_configuration(folder / "a.sumocfg")), text_of(settings));
}

TEST(Configuration, WhatIsNoneIsAnError) {
  const TemporaryFolder folder;
  EXPECT_TRUE(contains(input_error([&] { read_configuration(folder / "none.sumocfg"); }), "cannot read"));
  const auto cut = folder.write("cut.sumocfg", "<configuration>\n<begin value='1'/>\n");
  EXPECT_TRUE(contains(input_error([&] { read_configuration(cut); }), "cut.sumocfg:3: not well-formed XML"));
}

TEST(Configuration, FileListsAreSeenFromTheirFolder) {
  EXPECT_EQ(file_list(" a.xml, b c.xml ;,d.xml"), (std::vector<std::string>{"a.xml", "b c.xml", "d.xml"}));
  EXPECT_TRUE(file_list("").empty());
  EXPECT_EQ(resolve_files("a.xml, ../b.xml,/c/d.xml", "/x/y"), "/x/y/a.xml,/x/b.xml,/c/d.xml");
  EXPECT_EQ(resolve_files("", "/x"), "");
}

TEST(Settings, TheLaterOneWinsInThePlaceOfTheFirst) {
  Settings settings;
  settings.set("a", "1");
  settings.set("b", "2");
  settings.set("a", "3");
  EXPECT_EQ(text_of(settings.all()), "a=3\nb=2\n");
  EXPECT_EQ(settings.find("a"), "3");
  EXPECT_EQ(settings.find("c"), std::nullopt);
  settings.erase("a");
  settings.erase("c");
  EXPECT_EQ(settings.find("a"), std::nullopt);
  settings.set("device.x", "1");
  settings.erase_if([](const std::string& name) { return name.starts_with("device."); });
  EXPECT_EQ(text_of(settings.all()), "b=2\n");
}

}  // namespace
}  // namespace thalweg::testing
