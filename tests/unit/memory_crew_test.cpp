// SPDX-License-Identifier: Apache-2.0
#include "lab/memory_crew.hpp"

#include <gtest/gtest.h>

#include "core/dice.hpp"
#include "graph/grid.hpp"
#include "support/instance.hpp"

namespace thalweg::lab {
namespace {

using testing::make_instance;

//   0 --1--> 1 --1--> 3     what they expect; but 1 --> 3 costs 9 on every day
//   0 --2--> 2 --2--> 3
struct Fork {
  testing::Instance instance = make_instance(4, {{0, 1, 1}, {1, 3, 1}, {0, 2, 2}, {2, 3, 2}});
  std::vector<Millis> today{1, 9, 2, 2};
  MemoryCrew crew(std::size_t vehicles, Memory memory) const {
    const Errand errand{VertexId{0U}, VertexId{3U}};
    return {instance.graph, std::vector<Errand>(vehicles, errand), instance.costs, memory};
  }
};

TEST(MemoryCrew, WithoutMemoryEveryDayIsTheFirst) {
  const Fork fork;
  MemoryCrew crew = fork.crew(1, Memory::none);
  EXPECT_EQ(crew.drive(fork.today, 0), 10);
  EXPECT_EQ(crew.drive(fork.today, 0), 10);
}

TEST(MemoryCrew, AVehicleDrivesIntoTheSameHindranceOnlyOnce) {
  const Fork fork;
  MemoryCrew crew = fork.crew(2, Memory::own);
  EXPECT_EQ(crew.drive(fork.today, 0), 20) << "both have to learn it";
  EXPECT_EQ(crew.drive(fork.today, 0), 8);
}

// The second vehicle starts behind the first and is told before it comes to the fork.
//   4 --1--> 0, and the fork from there
TEST(MemoryCrew, WhatOneHasMetTheOthersKnowAtOnce) {
  const auto instance = make_instance(5, {{0, 1, 1}, {1, 3, 1}, {0, 2, 2}, {2, 3, 2}, {4, 0, 1}});
  const std::vector<Millis> today{1, 9, 2, 2, 1};
  const std::vector<Errand> errands{{VertexId{1U}, VertexId{3U}}, {VertexId{4U}, VertexId{3U}}};
  MemoryCrew shared(instance.graph, errands, instance.costs, Memory::shared);
  EXPECT_EQ(shared.drive(today, 0), 9 + 5);
  MemoryCrew own(instance.graph, errands, instance.costs, Memory::own);
  EXPECT_EQ(own.drive(today, 0), 9 + 11);
}

TEST(MemoryCrew, ARoadIsDearerForThoseWhoComeLater) {
  const Fork fork;
  EXPECT_EQ(fork.crew(3, Memory::none).drive(fork.instance.costs, 1), 2 + 4 + 6);
  // The first one's road is as expected, so nobody is warned; the second meets 1 + 1 on it and tells.
  EXPECT_LE(fork.crew(3, Memory::shared).drive(fork.instance.costs, 1), 2 + 4 + 6);
}

// Where nothing changes from day to day a crew learns, and never ends up above what it began with; and
// whoever knows everything drives the least cost.
TEST(MemoryCrew, LearnsWhatDoesNotChange) {
  const Digraph grid = grid_graph(6);
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Dice dice(seed);
    std::vector<Millis> today(grid.arc_count());
    for (Millis& cost : today) cost = dice.roll(5) == 0 ? 100 : 10;
    const std::vector<Millis> expected(grid.arc_count(), 10);
    std::vector<Errand> errands;
    for (int i = 0; i < 5; ++i) errands.push_back({VertexId{dice.roll(36)}, VertexId{dice.roll(36)}});
    const Millis informed = MemoryCrew(grid, errands, today, Memory::none).drive(today, 0);
    for (const Memory memory : {Memory::own, Memory::shared}) {
      MemoryCrew crew(grid, errands, expected, memory);
      const Millis first = crew.drive(today, 0);
      Millis last = first;
      for (int day = 0; day < 30; ++day) last = crew.drive(today, 0);
      EXPECT_LE(last, first) << "seed " << seed;
      EXPECT_GE(last, informed);
      // What they have not met they believe to be free, so they try it: nothing better is left at the end.
      EXPECT_EQ(last, informed) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace thalweg::lab
