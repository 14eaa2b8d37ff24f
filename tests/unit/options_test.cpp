// SPDX-License-Identifier: Apache-2.0
#include "app/options.hpp"

#include <gtest/gtest.h>

#include <map>

#include "support/input_error.hpp"
#include "support/temporary_folder.hpp"
#include "xml/node.hpp"

namespace thalweg::testing {
namespace {

Options some_options() {
  return {"run",
          "Runs",
          {{"input", "configuration-file", 'c', "FILE", "", "The configuration"},
           {"input", "net-file", 'n', "FILE", "", "The network"},
           {"time", "begin", 'b', "TIME", "0", "When it <begins> & why \"so\""},
           {"routing", "period", 0, "TIME", "60", "How often"},
           {"routing", "share", 0, "FLOAT", "1", "How many"},
           {"routing", "threads", 0, "INT", "1", "Threads"},
           {"routing", "strict", 0, "BOOL", "false", "Whether"},
           {"routing", "device.threshold", 0, "STR", "", "Dotted"},
           {"output", "write", 0, "BOOL", "true", "Whether it writes"}}};
}

Options parsed(const std::vector<std::string>& arguments) {
  Options options = some_options();
  options.parse(arguments);
  return options;
}

std::string error_of(const std::vector<std::string>& arguments) {
  return input_error([&] { parsed(arguments); });
}

TEST(Options, ValuesStandAfterABlankOrAnEqualsSign) {
  for (const auto& arguments : std::vector<std::vector<std::string>>{
           {"--net-file", "a.net.xml"}, {"--net-file=a.net.xml"}, {"-n", "a.net.xml"}}) {
    const Options options = parsed(arguments);
    EXPECT_EQ(options.text("net-file"), "a.net.xml") << arguments.front();
    EXPECT_TRUE(options.is_set("net-file"));
    EXPECT_TRUE(options.on_command_line("net-file"));
    EXPECT_FALSE(options.is_set("period"));
  }
  EXPECT_EQ(parsed({"--device.threshold", "a=b c"}).text("device.threshold"), "a=b c");
}

TEST(Options, DefaultsHoldUntilTheyAreOverwritten) {
  const Options options = parsed({});
  EXPECT_EQ(options.time("period"), 60'000);
  EXPECT_EQ(options.count("threads"), 1U);
  EXPECT_EQ(options.number("share"), 1);
  EXPECT_FALSE(options.flag("strict"));
  EXPECT_TRUE(options.flag("write"));
  EXPECT_FALSE(options.on_command_line("period"));
}

TEST(Options, TimesAreSecondsOrClockTimes) {
  EXPECT_EQ(parsed({"--begin", "1:0:0:30"}).time("begin"), 86'430'000);
  EXPECT_EQ(parsed({"-b", "0.5"}).time("begin"), 500);
  EXPECT_EQ(parsed({"-b", "-1"}).time("begin"), -1'000) << "a negative value is a value";
}

TEST(Options, BooleansTakeAnOptionalValue) {
  EXPECT_TRUE(parsed({"--strict"}).flag("strict"));
  EXPECT_TRUE(parsed({"--strict", "--threads", "2"}).flag("strict"));
  for (const char* yes : {"true", "1", "yes", "on", "True", "x", "t"}) {
    EXPECT_TRUE(parsed({"--strict", yes}).flag("strict")) << yes;
    EXPECT_TRUE(parsed({std::string("--strict=") + yes}).flag("strict")) << yes;
  }
  for (const char* no : {"false", "0", "no", "off", "FALSE", "f"}) {
    EXPECT_FALSE(parsed({"--write", no}).flag("write")) << no;
    EXPECT_FALSE(parsed({std::string("--write=") + no}).flag("write")) << no;
  }
  EXPECT_FALSE(parsed({"-v", "false"}).flag("verbose"));
  EXPECT_TRUE(parsed({"-v"}).flag("verbose"));
  EXPECT_EQ(parsed({"--device.threshold", "true"}).text("device.threshold"), "true") << "no boolean option";
}

TEST(Options, TheLastOfTwoCounts) {
  EXPECT_EQ(parsed({"--threads", "2", "--threads=3"}).count("threads"), 3U);
}

TEST(Options, WhatFollowsTwoDashesIsForSumo) {
  const Options options = parsed({"--threads", "2", "--", "--step-length", "0.5", "--unknown"});
  EXPECT_EQ(options.for_sumo(), (std::vector<std::string>{"--step-length", "0.5", "--unknown"}));
  EXPECT_EQ(options.count("threads"), 2U);
  EXPECT_TRUE(parsed({}).for_sumo().empty());
}

TEST(Options, TheCommandLineComesBeforeTheConfiguration) {
  Options options = parsed({"--threads", "2"});
  EXPECT_TRUE(options.take({.name = "threads", .value = "8"}));
  EXPECT_TRUE(options.take({.name = "share", .value = "0.5"}));
  EXPECT_FALSE(options.take({.name = "step-length", .value = "0.5"})) << "it is SUMO's";
  EXPECT_EQ(options.count("threads"), 2U);
  EXPECT_EQ(options.number("share"), 0.5);
  EXPECT_TRUE(options.is_set("share"));
  EXPECT_FALSE(options.on_command_line("share"));
  EXPECT_TRUE(options.take({.name = "n", .value = "b.net.xml"})) << "a synonym";
  EXPECT_EQ(options.text("net-file"), "b.net.xml");
  EXPECT_EQ(input_error([&] { options.take({.name = "share", .value = "half"}); }),
            "--share half: this is no number");
  EXPECT_TRUE(options.take({.name = "strict", .value = "True"})) << "as people write it in files";
  EXPECT_TRUE(options.flag("strict"));
}

TEST(Options, AnUnknownOptionIsAnErrorWithTheNearestName) {
  EXPECT_EQ(error_of({"--perod", "30"}),
            "there is no option '--perod' (did you mean 'period'?); 'thalweg run --help' lists them");
  EXPECT_EQ(error_of({"--perod=30"}),
            "there is no option '--perod' (did you mean 'period'?); 'thalweg run --help' lists them");
  EXPECT_TRUE(contains(error_of({"--completely-other"}), "there is no option '--completely-other';"));
  EXPECT_TRUE(contains(error_of({"-Z"}), "there is no option '-Z'"));
  EXPECT_TRUE(contains(error_of({"--peri", "30"}), "there is no option '--peri'")) << "nothing is guessed";
}

TEST(Options, AStrayArgumentIsNamed) {
  EXPECT_EQ(error_of({"--period", "30", "stray"}),
            "'stray' belongs to no option; 'thalweg run --help' lists them");
  EXPECT_TRUE(contains(error_of({"stray"}), "'stray' belongs to no option"));
  EXPECT_TRUE(contains(error_of({"-n", "net", "stray", "--threads", "2"}), "'stray' belongs to no option"));
}

TEST(Options, ValuesMustBeOfTheirType) {
  EXPECT_EQ(error_of({"--threads", "two"}), "--threads two: this is no whole number");
  EXPECT_EQ(error_of({"--threads=1.5"}), "--threads 1.5: this is no whole number");
  EXPECT_EQ(error_of({"--share", "nan"}), "--share nan: this is no number");
  EXPECT_EQ(error_of({"--period", "1:30"}), "--period 1:30: this is no time (seconds or [d:]h:m:s)");
  EXPECT_EQ(error_of({"--strict=maybe"}), "--strict maybe: this is no boolean (true or false)");
  EXPECT_EQ(error_of({"--strict", "maybe"}), "--strict maybe: this is no boolean (true or false)");
  EXPECT_TRUE(contains(error_of({"--threads"}), "threads"));
  EXPECT_TRUE(contains(error_of({"--threads="}), "--threads"));
  EXPECT_EQ(input_error([] {
              (void)parsed({"--threads", "-1"}).count("threads");
            }),
            "--threads -1: this is no whole number from 0 on");
}

TEST(Options, TheTemplateHoldsEveryOptionWithTypeDefaultAndHelp) {
  const TemporaryFolder folder;
  const auto file = folder.write("template.xml", parsed({"--threads", "2"}).to_xml(false));
  std::map<std::string, xml::Node> options;
  xml::read_nodes(
      file, [](const xml::Element& root) { EXPECT_EQ(root.name(), "configuration"); },
      [&](xml::Node& section) {
        for (xml::Node& option : section.children) options[section.name + "/" + option.name] = option;
      });
  EXPECT_EQ(options.size(), some_options().specs().size());
  const xml::Node& begin = options["time/begin"];
  EXPECT_EQ(begin.require("value"), "0");
  EXPECT_EQ(begin.require("type"), "TIME");
  EXPECT_EQ(begin.require("synonymes"), "b");
  EXPECT_EQ(begin.require("help"), "When it <begins> & why \"so\"");
  EXPECT_EQ(options["routing/threads"].require("value"), "1") << "the default, not what was set";
}

TEST(Options, ASavedConfigurationGivesTheSameOptions) {
  const TemporaryFolder folder;
  const Options saved = parsed({"--begin", "0:1:0", "--device.threshold", "<&\">", "--strict", "-n", "a.xml",
                                "--save-configuration", "x.cfg"});
  const auto settings = read_configuration(folder.write("a.cfg", saved.to_xml(true)));
  EXPECT_EQ(settings.size(), 4U) << "what is set, and nothing of the saving";
  Options again = parsed({});
  for (const Setting& setting : settings) EXPECT_TRUE(again.take(setting)) << setting.name;
  for (const OptionSpec& spec : again.specs()) {
    if (spec.name.starts_with("save-")) continue;
    EXPECT_EQ(again.text(spec.name), saved.text(spec.name)) << spec.name;
  }
}

TEST(Options, SavingIsTheWholeCommand) {
  const TemporaryFolder folder;
  EXPECT_FALSE(parsed({}).answered());
  const auto file = folder / "t.xml";
  EXPECT_TRUE(parsed({"--save-template", file.string()}).answered());
  EXPECT_EQ(read_bytes(file), parsed({}).to_xml(false));
  EXPECT_TRUE(parsed({"-C", file.string(), "--threads=2"}).answered());
  EXPECT_EQ(read_bytes(file), parsed({"--threads=2"}).to_xml(true));
}

TEST(Options, ASavedConfigurationMayBeReadFromAnywhere) {
  const TemporaryFolder folder;
  const auto file = folder / "saved.cfg";
  EXPECT_TRUE(parsed({"-C", file.string(), "-n", "a.xml,/b.xml"}).answered());
  Options again = parsed({});
  again.take_file(file);
  EXPECT_EQ(again.text("net-file"), (std::filesystem::current_path() / "a.xml").string() + ",/b.xml");
}

TEST(Options, AConfigurationOfOursIsSeenFromItsFolderAndUnderTheCommandLine) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.cfg",
                                 "<configuration><any><net-file value='sub/a.xml'/><b value='7'/>"
                                 "<threads value='3'/></any></configuration>");
  Options options = parsed({"--threads", "2"});
  options.take_file(file);
  EXPECT_EQ(options.text("net-file"), (folder / "sub/a.xml").string());
  EXPECT_EQ(options.time("begin"), 7'000);
  EXPECT_EQ(options.count("threads"), 2U);
  const auto bad = folder.write("bad.cfg", "<configuration><x><thread value='3'/></x></configuration>");
  EXPECT_TRUE(contains(input_error([&] { options.take_file(bad); }), "did you mean 'threads'"));
  EXPECT_TRUE(contains(input_error([&] { options.take_file(folder / "none.cfg"); }), "does not exist"));
}

TEST(Options, TheHeaderSaysWhatMadeTheFileAndWithWhichOptions) {
  const std::string header = parsed({"-n", "a.xml"}).header();
  for (const char* part : {"generated on 2", "by thalweg run ", "<net-file value=\"a.xml\"/>"}) {
    EXPECT_TRUE(contains(header, part));
  }
}

TEST(Options, HelpShowsSectionsNamesTypesAndDefaults) {
  const std::string help = some_options().help();
  for (const char* part : {"Usage: thalweg run [options]", "\nrouting:\n", "  -n, --net-file FILE",
                           "      --period TIME", "How often [60]", "  -?, --help"}) {
    EXPECT_TRUE(contains(help, part));
  }
}

TEST(Options, HelpKeepsASectionTogether) {
  const std::string help = Options("run", "one run",
                                   {{"input", "net-file", 'n', "FILE", "", "The network"},
                                    {"routing", "period", 0, "TIME", "60", "How often"},
                                    {"input", "memory-input", 0, "FILE", "", "The days before"}})
                               .help();
  EXPECT_LT(help.find("--memory-input"), help.find("\nrouting:\n"));
  EXPECT_EQ(help.find("\ninput:\n"), help.rfind("\ninput:\n"));
}

}  // namespace
}  // namespace thalweg::testing
