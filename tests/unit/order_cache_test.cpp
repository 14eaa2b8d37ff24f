// SPDX-License-Identifier: Apache-2.0
#include "cch/order_cache.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "graph/fingerprint.hpp"
#include "graph/grid.hpp"
#include "support/temporary_folder.hpp"

namespace thalweg::testing {
namespace {

namespace fs = std::filesystem;

class OrderCacheTest : public ::testing::Test {
 protected:
  EliminationOrder order(const Digraph& graph) {
    warnings.clear();
    return cached_dissection(
        graph, fingerprint(graph),
        {.folder = folder, .warn = [&](const std::string& text) { warnings.push_back(text); }});
  }
  [[nodiscard]] fs::path only_file() const {
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
    return fs::directory_iterator(folder)->path();
  }
  static std::string content(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  static void overwrite(const fs::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
  }

  TemporaryFolder temporary;
  fs::path folder = temporary.path() / "cache" / "thalweg";
  Digraph grid = grid_graph(9);
  EliminationOrder expected = nested_dissection(grid);
  std::vector<std::string> warnings;
};

TEST_F(OrderCacheTest, KeepsAnOrder) {
  EXPECT_EQ(order(grid), expected);
  const fs::path file = only_file();
  const auto written = fs::last_write_time(file);
  EXPECT_EQ(order(grid), expected);
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(fs::last_write_time(file), written) << "read, not made anew";
}

TEST_F(OrderCacheTest, EveryGraphHasItsOwn) {
  order(grid);
  const Digraph other = grid_graph(8);
  EXPECT_EQ(order(other), nested_dissection(other));
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 2);
}

TEST_F(OrderCacheTest, WhatIsDamagedIsMadeAnewWithAWarning) {
  order(grid);
  const fs::path file = only_file();
  const std::string whole = content(file);
  std::string flipped = whole;
  flipped[whole.size() / 2] = static_cast<char>(flipped[whole.size() / 2] ^ 1);
  std::string of_another_graph = whole;
  of_another_graph[8] = static_cast<char>(of_another_graph[8] ^ 1);
  std::string of_another_version = whole;
  of_another_version[0] = static_cast<char>(of_another_version[0] ^ 1);
  for (const std::string& bad :
       {flipped, of_another_graph, of_another_version, whole.substr(0, whole.size() - 1), whole + "x",
        std::string(), std::string("no order at all")}) {
    overwrite(file, bad);
    EXPECT_EQ(order(grid), expected);
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_NE(warnings.front().find(file.filename().string()), std::string::npos);
    EXPECT_EQ(content(file), whole);
  }
}

TEST_F(OrderCacheTest, AFolderThatCannotBeWrittenIsAWarning) {
  overwrite(temporary.path() / "file", "in the way");
  folder = temporary.path() / "file" / "thalweg";
  EXPECT_EQ(order(grid), expected);
  EXPECT_EQ(warnings.size(), 1U);
}

TEST_F(OrderCacheTest, NoFolderIsNoCache) {
  folder.clear();
  EXPECT_EQ(order(grid), expected);
  EXPECT_TRUE(warnings.empty());
  EXPECT_TRUE(fs::is_empty(temporary.path()));
}

TEST_F(OrderCacheTest, OfNothing) {
  EXPECT_TRUE(order(Digraph()).empty());
  EXPECT_TRUE(order(Digraph()).empty());
  EXPECT_TRUE(warnings.empty());
}

}  // namespace
}  // namespace thalweg::testing
