// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/hash.hpp"
#include "core/id.hpp"
#include "core/nearest.hpp"
#include "core/number.hpp"
#include "core/parallel.hpp"
#include "core/rows.hpp"

namespace thalweg {
namespace {

// The value is part of every result (whose turn it is when): it may never change.
TEST(Hash, IsTheSameEverywhere) {
  EXPECT_EQ(stable_hash("a"), stable_hash("a"));
  EXPECT_NE(stable_hash("a"), stable_hash("b"));
  EXPECT_EQ(stable_hash("vehicle_1"), 0x1bb0e1f6738ac53eULL);
  static_assert(stable_hash("x") != 0, "it is known at compile time");
}

TEST(Hash, NumbersOfNeighbouringNamesAreSpreadEvenly) {
  std::vector<int> tenths(10);
  for (int i = 0; i < 10'000; ++i) {
    const double number = unit_hash("veh" + std::to_string(i));
    ASSERT_GE(number, 0);
    ASSERT_LT(number, 1);
    ++tenths[static_cast<std::size_t>(number * 10)];
  }
  for (const int count : tenths) EXPECT_NEAR(count, 1'000, 120);
}

TEST(Nearest, IsTheNameWithTheFewestChangedLetters) {
  const std::vector<std::string> names{"hybrid", "evolved", "dijkstra"};
  EXPECT_EQ(nearest_name("hibrid", names), "hybrid");
  EXPECT_EQ(nearest_name("djikstra", names), "dijkstra");
  EXPECT_EQ(nearest_name("evolve", names), "evolved");
  EXPECT_EQ(nearest_name("hybrid", names), "hybrid");
  EXPECT_EQ(nearest_name("contraction", names), "");
  EXPECT_EQ(nearest_name("", names), "");
  EXPECT_EQ(nearest_name("hybrid", {}), "");
  EXPECT_EQ(did_you_mean("hibrid", names), " (did you mean 'hybrid'?)");
  EXPECT_EQ(did_you_mean("contraction", names), "");
}

TEST(Parallel, EveryItemIsWorkedOnOnce) {
  for (const std::size_t threads : {0U, 1U, 2U, 4U, 9U}) {
    for (const std::size_t items : {0U, 1U, 3U, 1'000U}) {
      std::vector<int> done(items);
      std::atomic<bool> is_worker_known = true;
      parallel_for(items, threads, [&](std::size_t item, std::size_t worker) {
        ++done[item];
        if (worker >= std::max<std::size_t>(1, threads)) is_worker_known = false;
      });
      EXPECT_EQ(done, std::vector<int>(items, 1)) << threads << " threads";
      EXPECT_TRUE(is_worker_known);
    }
  }
}

TEST(Parallel, AWorkerIsOneThreadAtATime) {
  std::vector<std::atomic<int>> inside(4);
  std::atomic<bool> clashed = false;
  parallel_for(2'000, 4, [&](std::size_t, std::size_t worker) {
    if (++inside[worker] != 1) clashed = true;
    --inside[worker];
  });
  EXPECT_FALSE(clashed);
}

TEST(Parallel, AnExceptionComesOutAndEndsTheWork) {
  for (const std::size_t threads : {1U, 4U}) {
    std::atomic<std::size_t> done = 0;
    const auto work = [&](std::size_t item, std::size_t) {
      if (item == 10) throw std::runtime_error("item 10");
      ++done;
    };
    EXPECT_THROW(parallel_for(10'000'000, threads, work), std::runtime_error);
    EXPECT_LT(done, 10'000'000U - 1) << threads << " threads";
  }
}

// The items of a forest: 0 and 3 below 4, 1 and 2 below 3; 5 below 6.
constexpr std::array<std::size_t, 7> forest{4, 3, 3, 4, 4, 6, 6};

TEST(ParallelTree, ChildrenAreDoneBeforeTheirParent) {
  for (const std::size_t threads : {0U, 1U, 2U, 4U, 9U}) {
    std::array<std::atomic<bool>, forest.size()> done{};
    std::atomic<int> early = 0;
    parallel_tree(forest, threads, [&](std::size_t item, std::size_t worker) {
      EXPECT_LT(worker, std::max<std::size_t>(1, threads));
      for (std::size_t child = 0; child < forest.size(); ++child) {
        if (forest[child] == item && child != item && !done[child]) ++early;
      }
      EXPECT_FALSE(done[item].exchange(true)) << item << " is done twice";
    });
    EXPECT_EQ(early, 0) << threads << " threads";
    for (std::size_t item = 0; item < forest.size(); ++item) EXPECT_TRUE(done[item]) << item;
  }
  parallel_tree({}, 4, [](std::size_t, std::size_t) { FAIL() << "there is nothing to do"; });
}

TEST(ParallelTree, AnExceptionComesOutAndEndsTheWork) {
  for (const std::size_t threads : {1U, 4U}) {
    std::atomic<bool> is_root_done = false;
    const auto work = [&](std::size_t item, std::size_t) {
      if (item == 1) throw std::runtime_error("item 1");
      if (item == 4) is_root_done = true;
    };
    EXPECT_THROW(parallel_tree(forest, threads, work), std::runtime_error);
    EXPECT_FALSE(is_root_done);
  }
}

TEST(Number, IsReadWholeAndFinite) {
  EXPECT_EQ(parse_number(" 1.5e2 "), 150);
  EXPECT_EQ(parse_number("+3"), 3);
  for (const char* text : {"", " ", "x", "1x", "1,5", "nan", "-inf", "1e999", "0x10", "+-1"})
    EXPECT_EQ(parse_number(text), std::nullopt) << text;
  EXPECT_EQ(parse_integer<int>(" -4 "), -4);
  for (const char* text : {"", "1.0", "1 2", "99999999999"})
    EXPECT_EQ(parse_integer<int>(text), std::nullopt) << text;
  EXPECT_EQ(parse_integer<unsigned>("-1"), std::nullopt);
}

TEST(Number, SplitDropsWhatIsEmpty) {
  using Parts = std::vector<std::string_view>;
  EXPECT_EQ(split(" a,b, c ", " ,"), (Parts{"a", "b", "c"}));
  EXPECT_EQ(split("", ","), Parts{});
  EXPECT_EQ(split(",,", ","), Parts{});
  EXPECT_EQ(split("one", ","), Parts{"one"});
}

TEST(Rows, HoldTheirItemsInTheOrderInWhichTheyCame) {
  const std::string words[] = {"cab", "a", "bud", "ape", "cow", "", "bee"};
  std::vector<unsigned> first;
  std::vector<std::string> rows;
  const auto for_each = [&](const auto& visit) {
    for (const std::string& word : words) {
      if (!word.empty()) visit(static_cast<std::size_t>(word.front() - 'a'), [&] { return word; });
    }
  };
  fill_rows(4, for_each, first, rows);  // nothing begins with a d
  EXPECT_EQ(first, (std::vector<unsigned>{0, 2, 4, 6, 6}));
  EXPECT_EQ(rows, (std::vector<std::string>{"a", "ape", "bud", "bee", "cab", "cow"}));
}

TEST(Id, AnEmptyIdNamesNothing) {
  EXPECT_FALSE(RoadId{}.valid());
  EXPECT_TRUE(RoadId{0U}.valid());
  IdVector<RoadId, int> numbers;
  EXPECT_EQ(numbers.next_id(), RoadId{0U});
  EXPECT_EQ(numbers.push_back(7), RoadId{0U});
  EXPECT_EQ(numbers[RoadId{0U}], 7);
}

}  // namespace
}  // namespace thalweg
