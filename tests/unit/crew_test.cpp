// SPDX-License-Identifier: Apache-2.0
#include "lab/crew.hpp"

#include <gtest/gtest.h>

#include "core/dice.hpp"
#include "graph/grid.hpp"
#include "support/instance.hpp"

namespace thalweg::lab {
namespace {

using testing::make_instance;

//   0 <-> 1 <-> 2 with a bay: 1 <-> 3. Two want to pass each other.
TEST(Crew, TheTableSendsOneIntoTheBayWhereWithoutItBothWaitForEver) {
  const auto lane = make_instance(4, {{0, 1}, {1, 0}, {1, 2}, {2, 1}, {1, 3}, {3, 1}});
  const Errand errands[] = {{VertexId{0U}, VertexId{2U}}, {VertexId{2U}, VertexId{0U}}};
  const CrewOutcome planned = crew_with_table(lane.graph, errands, 20);
  EXPECT_EQ(planned.arrival[0], 2U);
  ASSERT_TRUE(planned.arrival[1].has_value());
  EXPECT_GT(*planned.arrival[1], 2U);
  EXPECT_EQ(crew_without_table(lane.graph, errands, 20).arrived(), 0U);
}

TEST(Crew, OneVehicleArrivesTheSameEitherWay) {
  const Digraph grid = grid_graph(4);
  const Errand errands[] = {{VertexId{0U}, VertexId{15U}}, {VertexId{3U}, VertexId{3U}}};
  for (const CrewOutcome& out : {crew_with_table(grid, errands, 50), crew_without_table(grid, errands, 50)}) {
    EXPECT_EQ(out.arrival[0], 6U);
    EXPECT_EQ(out.arrival[1], 0U);
  }
  EXPECT_EQ(crew_with_table(grid, errands, 5).arrived(), 1U) << "beyond the horizon";
}

// The second wants the same way, and starts a step later: it sees the first one's bookings.
TEST(Crew, EachBookingIsSeenByThoseAfterIt) {
  const auto lane = make_instance(3, {{0, 1}, {1, 2}});
  const Errand errands[] = {{VertexId{0U}, VertexId{2U}}, {VertexId{0U}, VertexId{2U}}};
  const CrewOutcome planned = crew_with_table(lane.graph, errands, 20);
  EXPECT_EQ(planned.arrival[0], 2U);
  EXPECT_EQ(planned.arrival[1], 3U);
}

TEST(Crew, NobodyIsLostWithTheTable) {
  const Digraph grid = grid_graph(6);
  std::size_t jammed = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Dice dice(seed);
    std::vector<Errand> errands;
    errands.reserve(20);
    for (int i = 0; i < 20; ++i) errands.push_back({VertexId{dice.roll(36)}, VertexId{dice.roll(36)}});
    EXPECT_EQ(crew_with_table(grid, errands, 200).arrived(), 20U) << "seed " << seed;
    jammed += crew_without_table(grid, errands, 200).arrived() < 20 ? 1U : 0U;
  }
  EXPECT_GT(jammed, 10U);
}

}  // namespace
}  // namespace thalweg::lab
