// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "support/input_error.hpp"
#include "support/temporary_folder.hpp"
#include "xml/node.hpp"
#include "xml/reader.hpp"
#include "xml/writer.hpp"

namespace thalweg::testing {
namespace {

/// Notes what a file holds: "+name a=1" and "-name".
class Notes : public xml::Handler {
 public:
  void start(const xml::Element& element) override {
    std::string line = "+" + std::string(element.name());
    for (const auto& a : element.attributes()) line += " " + std::string(a.name) + "=" + std::string(a.value);
    lines.push_back(line);
  }
  void end(std::string_view name) override { lines.push_back("-" + std::string(name)); }
  std::vector<std::string> lines;
};

std::vector<std::string> notes_of(const std::filesystem::path& file) {
  Notes notes;
  xml::read(file, notes);
  return notes.lines;
}

/// Calls `action` with each opening tag.
template <class Action>
class OnStart : public xml::Handler {
 public:
  explicit OnStart(Action action) : action_(action) {}
  void start(const xml::Element& element) override { action_(element); }

 private:
  Action action_;
};

template <class Action>
void parse_with(std::string_view text, Action action) {
  OnStart<Action> handler(action);
  xml::parse(text, "x.xml", handler);
}

const std::string small = "<a x='1'>\n <b y='2' z='&lt;&amp;&gt;&quot;&#228;'/>\n words\n</a>\n";
const std::vector<std::string> small_notes{"+a x=1", "+b y=2 z=<&>\"ä", "-b", "-a"};

TEST(XmlReader, ReadsPlainAndGzippedFilesAlike) {
  const TemporaryFolder folder;
  EXPECT_EQ(notes_of(folder.write("a.xml", small)), small_notes);
  EXPECT_EQ(notes_of(folder.write_gzip("a.xml.gz", small)), small_notes);
  EXPECT_EQ(notes_of(folder.write_gzip("zipped-all-the-same.xml", small)), small_notes);
}

TEST(XmlReader, FilesThatCannotBeRead) {
  const TemporaryFolder folder;
  const auto error = [&](const std::filesystem::path& file) { return input_error([&] { notes_of(file); }); };
  const std::string quoted = "'" + folder.path().string();
  EXPECT_EQ(error(folder / "none.xml"), "cannot read " + quoted + "/none.xml': No such file or directory");
  EXPECT_EQ(error(folder.path()), "cannot read " + quoted + "': it is a folder");
}

std::string incompressible() {
  std::string text = "<a>";
  unsigned value = 1;
  for (int i = 0; i < 50'000; ++i) {
    value = value * 1'664'525U + 1'013'904'223U;
    text += "<b c='" + std::to_string(value) + "'/>";
  }
  return text + "</a>";
}

TEST(XmlReader, ATruncatedGzipIsAnError) {
  const TemporaryFolder folder;
  const std::string whole = read_bytes(folder.write_gzip("whole.xml.gz", incompressible()));
  ASSERT_EQ(notes_of(folder / "whole.xml.gz").size(), 2U * 50'001U);
  for (const std::size_t size : {whole.size() / 2, whole.size() - 1, std::size_t{20}}) {
    const auto cut = folder.write("cut.xml.gz", whole.substr(0, size));
    EXPECT_TRUE(contains(input_error([&] { notes_of(cut); }), "cut.xml.gz' is cut short"))
        << size << " bytes";
  }
}

TEST(XmlReader, ADamagedGzipIsAnError) {
  const TemporaryFolder folder;
  std::string bytes = read_bytes(folder.write_gzip("whole.xml.gz", incompressible()));
  for (std::size_t i = bytes.size() / 2; i < bytes.size() / 2 + 50; ++i) bytes[i] = '\x5a';
  const auto file = folder.write("damaged.xml.gz", bytes);
  EXPECT_TRUE(contains(input_error([&] { notes_of(file); }), "damaged.xml.gz"));
}

TEST(XmlReader, MalformedXmlIsNamedByItsFirstErrorAndLine) {
  const TemporaryFolder folder;
  const auto error = [&](std::string_view text) {
    return input_error([&] { notes_of(folder.write("bad.xml", text)); });
  };
  EXPECT_TRUE(
      contains(error("<a>\n<b>\n</c></a>"), "bad.xml:3: not well-formed XML: Opening and ending tag"));
  EXPECT_TRUE(
      contains(error("<a>\n<b x='1' x='2'/></a>"), "bad.xml:2: not well-formed XML: Attribute x redefined"));
  EXPECT_TRUE(contains(error(""), "bad.xml:1: not well-formed XML: Document is empty"));
  EXPECT_TRUE(contains(error("<a/><a/>"), "bad.xml:1: not well-formed XML"));
  EXPECT_TRUE(contains(error("<a x='\xff\xfe'/>"), "bad.xml:1: not well-formed XML"));
}

TEST(XmlReader, NoEntityIsExpandedAndNothingElseIsRead) {
  const TemporaryFolder folder;
  const auto secret = folder.write("secret.txt", "secret");
  const std::string type = "<!DOCTYPE a [<!ENTITY s SYSTEM \"file://" + secret.string() + "\">]>\n";
  const auto file = folder.write("bad.xml", "<?xml version='1.0'?>\n" + type + "<a x='1'>&s;</a>");
  const std::string message = input_error([&] { notes_of(file); });
  EXPECT_EQ(message, file.string() + ":2: <!DOCTYPE>: document types and entities are not accepted");
}

TEST(XmlReader, WhatTheHandlerThrowsComesOutAtOnce) {
  int seen = 0;
  const auto fail_at_second = [&](const xml::Element& element) {
    if (++seen == 2) throw std::logic_error(element.place());
  };
  EXPECT_THROW(
      {
        try {
          parse_with("<a>\n<b/>\n<c/></a>", fail_at_second);
        } catch (const std::logic_error& error) {
          EXPECT_STREQ(error.what(), "x.xml:2");
          throw;
        }
      },
      std::logic_error);
  EXPECT_EQ(seen, 2);
}

TEST(XmlElement, GivesAttributesTheirTypes) {
  parse_with("<a id='i' number=' 2.5 ' integer='-3' time='0:01:00' yes='True' no='0' empty=''/>",
             [](const xml::Element& a) {
               EXPECT_EQ(a.require("id"), "i");
               EXPECT_EQ(a.find("none"), std::nullopt);
               EXPECT_EQ(a.find("empty"), "");
               EXPECT_EQ(a.value_or("none", "else"), "else");
               EXPECT_EQ(a.number("number"), 2.5);
               EXPECT_EQ(a.number_or("none", 4), 4);
               EXPECT_EQ(a.number_or("number", 4), 2.5);
               EXPECT_EQ(a.integer("integer"), -3);
               EXPECT_EQ(a.time("time"), 60'000);
               EXPECT_TRUE(a.boolean_or("yes", false));
               EXPECT_FALSE(a.boolean_or("no", true));
               EXPECT_TRUE(a.boolean_or("none", true));
             });
}

TEST(XmlElement, ErrorsNameFileLineAndElement) {
  parse_with("<a\n id='i' word='x'/>", [](const xml::Element& a) {
    const auto expect = [](auto action, const std::string& message) {
      const std::string text = input_error(action);
      EXPECT_TRUE(contains(text, "x.xml:"));
      EXPECT_TRUE(contains(text, ": <a id='i'>: " + message));
    };
    expect([&] { (void)a.require("none"); }, "the attribute 'none' is missing");
    expect([&] { (void)a.number("none"); }, "the attribute 'none' is missing");
    expect([&] { (void)a.number("word"); }, "word='x' is not a number");
    expect([&] { (void)a.integer("word"); }, "word='x' is not a whole number");
    expect([&] { (void)a.time("word"); }, "word='x' is not a time");
    expect([&] { (void)a.number_or("word", 1); }, "word='x' is not a number");
  });
}

TEST(XmlWriter, WritesWhatTheReaderReads) {
  const TemporaryFolder folder;
  const std::string odd = "<&>\"'ä\n\t ";
  for (const char* name : {"a.xml", "a.xml.gz"}) {
    xml::Writer writer(folder / name, "made for -- a test ---");
    writer.open("root").open("child").attribute("odd", odd).close().open("empty").close();
    writer.commit();
    EXPECT_EQ(notes_of(folder / name), (std::vector<std::string>{"+root", "+child odd=" + odd, "-child",
                                                                 "+empty", "-empty", "-root"}));
  }
  const std::string plain = read_bytes(folder / "a.xml");
  EXPECT_TRUE(plain.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n")) << plain;
  EXPECT_TRUE(contains(plain, "made for"));
  EXPECT_TRUE(contains(plain, "\n    <child odd=\"&lt;&amp;"));
  EXPECT_EQ(read_bytes(folder / "a.xml.gz").substr(0, 2), "\x1f\x8b");
}

TEST(XmlWriter, NothingIsLeftBehindWithoutCommit) {
  const TemporaryFolder folder;
  folder.write("old.xml", "old");
  {
    xml::Writer fresh(folder / "new.xml", "x");
    xml::Writer over(folder / "old.xml", "x");
    OutputFile file(folder / "file.gz");
    fresh.open("a");
    over.open("a");
    file.write("text");
    EXPECT_FALSE(std::filesystem::exists(folder / "new.xml")) << "nobody sees half a file";
    EXPECT_EQ(read_bytes(folder / "old.xml"), "old");
  }
  EXPECT_EQ(folder.files(), std::vector<std::string>{"old.xml"});
  EXPECT_EQ(read_bytes(folder / "old.xml"), "old");
}

TEST(XmlWriter, CommitReplacesTheFileAndLeavesNothingElse) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old and longer");
  OutputFile file(folder / "a.txt");
  file.write("new");
  file.write("");
  file.commit();
  EXPECT_EQ(read_bytes(folder / "a.txt"), "new");
  EXPECT_EQ(folder.files(), std::vector<std::string>{"a.txt"});
}

TEST(XmlWriter, PlacesThatCannotBeWritten) {
  const TemporaryFolder folder;
  const auto nowhere = folder / "none/a.xml";
  EXPECT_EQ(input_error([&] { xml::Writer(nowhere, "x"); }),
            "cannot write '" + nowhere.string() + "': No such file or directory");
  std::filesystem::create_directory(folder / "folder");
  const auto is_folder = folder / "folder";
  EXPECT_TRUE(contains(input_error([&] {
                         OutputFile file(is_folder);
                         file.write("x");
                         file.commit();
                       }),
                       "cannot write '" + is_folder.string() + "'"));
  EXPECT_TRUE(folder.files().empty());
}

TEST(XmlWriter, AFullDiskIsAnErrorAndLeavesNothing) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  const TemporaryFolder folder;
  // The writer opens its temporary name, which leads to the full device.
  const auto temporary = folder / ("a.txt." + std::to_string(getpid()) + ".tmp");
  std::filesystem::create_symlink("/dev/full", temporary);
  EXPECT_TRUE(contains(input_error([&] {
                         OutputFile file(folder / "a.txt");
                         file.write(std::string(1U << 20U, 'x'));
                         file.commit();
                       }),
                       "a.txt': No space left on device"));
  EXPECT_TRUE(folder.files().empty());
}

TEST(XmlNode, AFileComesBackAsItWas) {
  const TemporaryFolder folder;
  const auto from = folder.write(
      "from.xml",
      "<root version='1'>\n<a id='1&amp;2' x='&lt;'>\n<b><c d='e'/></b><b/>\n</a>\n<f/>\n</root>");
  std::vector<std::string> places;
  xml::Writer writer(folder / "to.xml", "copy");
  xml::read_nodes(
      from,
      [&](const xml::Element& root) {
        EXPECT_EQ(root.require("version"), "1");
        writer.open(root.name()).attribute("version", "1");
      },
      [&](xml::Node& node) {
        places.push_back(node.place);
        write_node(writer, node);
      });
  writer.commit();
  EXPECT_EQ(notes_of(folder / "to.xml"), notes_of(from));
  EXPECT_EQ(places, (std::vector<std::string>{from.string() + ":2", from.string() + ":5"}));
}

//   a.xml: 1, part/b.xml, 4        part/b.xml: 2, c.xml        part/c.xml: 3
TEST(XmlNode, IncludedFilesAreReadInTheirPlace) {
  TemporaryFolder folder;
  std::filesystem::create_directories(folder / "part");
  const auto a = folder.write("a.xml", R"(<a><x id="1"/><include href="part/b.xml"/><x id="4"/></a>)");
  folder.write("part/b.xml", R"(<a><x id="2"/><include href="c.xml"/></a>)");
  folder.write("part/c.xml", R"(<a><x id="3"/></a>)");
  std::string seen;
  const auto read = [&] {
    xml::read_nodes_and_included(a, [&](const xml::Node& node, const std::filesystem::path& file) {
      seen += node.require("id") + file.filename().string() + " ";
    });
  };
  read();
  EXPECT_EQ(seen, "1a.xml 2b.xml 3c.xml 4a.xml ");
  folder.write("part/c.xml", R"(<a><include href="../part/b.xml"/></a>)");
  EXPECT_TRUE(contains(input_error(read), "b.xml includes itself"));
}

TEST(XmlNode, AttributesCanBeChanged) {
  xml::Node node{.name = "trip", .attributes = {{"id", "t"}, {"from", "a"}}, .children = {}, .place = "f:3"};
  node.set("from", "b");
  node.set("to", "c");
  node.erase("id");
  EXPECT_EQ(node.find("id"), nullptr);
  EXPECT_EQ(node.require("from"), "b");
  EXPECT_EQ(node.value_or("to", ""), "c");
  EXPECT_EQ(node.attributes.size(), 2U);
  EXPECT_EQ(input_error([&] { (void)node.require("id"); }), "f:3: <trip>: the attribute 'id' is missing");
  node.set("id", "t2");
  EXPECT_STREQ(node.error("odd").what(), "f:3: <trip id='t2'>: odd");
}

}  // namespace
}  // namespace thalweg::testing
