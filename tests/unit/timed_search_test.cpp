// SPDX-License-Identifier: Apache-2.0
#include "search/timed_search.hpp"

#include <gtest/gtest.h>

#include "support/random_graph.hpp"

namespace thalweg::testing {
namespace {

const auto no_potential = [](VertexId, Millis, Millis) -> Millis { return 0; };

//     0 --1--> 1 --f--> 3     f takes 100 until time 5, and 1 from then on, but nobody who leaves later
//      \               ^      arrives earlier: it falls by one each unit of time
//       ---5--> 2 --1-/
TEST(TimedSearch, TakesTheCostOfTheTimeAtWhichAnArcIsEntered) {
  const std::vector<ArcEnds> arcs{{VertexId{0U}, VertexId{1U}},
                                  {VertexId{1U}, VertexId{3U}},
                                  {VertexId{0U}, VertexId{2U}},
                                  {VertexId{2U}, VertexId{3U}}};
  const Digraph graph(4, arcs);
  const auto arrive = [](ArcId arc, Millis entry) -> Millis {
    if (arc == ArcId{0U} || arc == ArcId{3U}) return entry + 1;
    if (arc == ArcId{2U}) return entry + 5;
    return std::max<Millis>(entry + 1, 20);  // closed until 19
  };
  TimedScratch scratch;
  const auto early =
      timed_search(graph, VertexId{0U}, 0, 0, VertexId{3U}, {}, arrive, no_toll, no_potential, scratch);
  ASSERT_TRUE(early.has_value());
  EXPECT_EQ(early->arrival, 6);
  EXPECT_EQ(early->arcs, (std::vector<ArcId>{ArcId{2U}, ArcId{3U}}));
  const auto late =
      timed_search(graph, VertexId{0U}, 30, 0, VertexId{3U}, {}, arrive, no_toll, no_potential, scratch);
  EXPECT_EQ(late->arrival, 32);
  EXPECT_EQ(late->arcs, (std::vector<ArcId>{ArcId{0U}, ArcId{1U}}));
}

TEST(TimedSearch, FindsNothingThatIsNotEarlierThanTheBound) {
  const std::vector<ArcEnds> arcs{{VertexId{0U}, VertexId{1U}}};
  const Digraph graph(2, arcs);
  const auto arrive = [](ArcId, Millis entry) -> Millis { return entry + 10; };
  TimedScratch scratch;
  EXPECT_FALSE(timed_search(graph, VertexId{0U}, 0, 0, VertexId{1U}, {.below = 10}, arrive, no_toll,
                            no_potential, scratch));
  EXPECT_TRUE(timed_search(graph, VertexId{0U}, 0, 0, VertexId{1U}, {.below = 11}, arrive, no_toll,
                           no_potential, scratch));
  EXPECT_FALSE(
      timed_search(graph, VertexId{1U}, 0, 0, VertexId{0U}, {}, arrive, no_toll, no_potential, scratch));
}

//     0 --1--> 1 --1--> 3     whoever leaves 1 owes the others 10: the way by 2 is later, and better for all
//      \               ^
//       ---5--> 2 --1-/
TEST(TimedSearch, WeighsWhatIsOwed) {
  const std::vector<ArcEnds> arcs{{VertexId{0U}, VertexId{1U}},
                                  {VertexId{1U}, VertexId{3U}},
                                  {VertexId{0U}, VertexId{2U}},
                                  {VertexId{2U}, VertexId{3U}}};
  const Digraph graph(4, arcs);
  const auto arrive = [](ArcId arc, Millis entry) -> Millis { return entry + (arc == ArcId{2U} ? 5 : 1); };
  TimedScratch scratch;
  for (const Millis toll : {Millis{3}, Millis{10}}) {
    const auto owed = [&](VertexId v, Millis) -> Millis { return v == VertexId{1U} ? toll : 0; };
    const auto found =
        timed_search(graph, VertexId{0U}, 0, 7, VertexId{3U}, {}, arrive, owed, no_potential, scratch);
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->arrival, toll == 3 ? 2 : 6);
    EXPECT_EQ(found->owed, toll == 3 ? 10 : 7) << "what was owed before comes on top";
    const auto early = timed_search(graph, VertexId{0U}, 0, 7, VertexId{3U}, {.latest = 5}, arrive, owed,
                                    no_potential, scratch);
    ASSERT_TRUE(early.has_value());
    EXPECT_EQ(early->arrival, 2) << "not after 5, whatever it owes";
  }
}

/// Piecewise linear travel times whose arrival never falls: base + |phase| bent every 40 units.
Millis bent(std::uint64_t arc, Millis entry) {
  const Millis base = 1 + static_cast<Millis>(arc * 7919 % 50);
  const Millis phase = (entry + static_cast<Millis>(arc * 104729 % 40)) % 80;
  return entry + base + (phase < 40 ? phase : 80 - phase);
}

// Against Bellman-Ford on the arrival times; and with the exact distances of the lower bounds as potentials.
TEST(TimedSearch, EqualsLabelCorrectingOnRandomGraphs) {
  TimedScratch scratch;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const Instance instance = random_instance(static_cast<InstanceType>(seed % 3), seed);
    const Digraph& graph = instance.graph;
    const std::size_t n = graph.vertex_count();
    const VertexId origin{seed % n};
    const Millis start = static_cast<Millis>(seed % 97);
    IdVector<VertexId, Millis> earliest(n, infinity);
    earliest[origin] = start;
    for (std::size_t round = 0; round < n; ++round) {
      for (std::size_t a = 0; a < graph.arc_count(); ++a) {
        const auto [tail, head] = graph.ends(ArcId{a});
        if (earliest[tail] < infinity) earliest[head] = std::min(earliest[head], bent(a, earliest[tail]));
      }
    }
    for (std::size_t v = 0; v < n; ++v) {
      IdVector<VertexId, Millis> left(n, infinity);  // least time to v when nothing is bent
      left[VertexId{v}] = 0;
      for (std::size_t round = 0; round < n; ++round) {
        for (std::size_t a = 0; a < graph.arc_count(); ++a) {
          const auto [tail, head] = graph.ends(ArcId{a});
          left[tail] =
              std::min(left[tail], add_saturating(left[head], 1 + static_cast<Millis>(a * 7919 % 50)));
        }
      }
      const auto arrive = [](ArcId arc, Millis entry) { return bent(arc.value, entry); };
      const auto found = timed_search(
          graph, origin, start, 0, VertexId{v}, {}, arrive, no_toll,
          [&](VertexId u, Millis, Millis) { return left[u]; }, scratch);
      ASSERT_EQ(found ? found->arrival : infinity, earliest[VertexId{v}])
          << "seed " << seed << " vertex " << v;
      if (!found) continue;
      Millis time = start;
      for (const ArcId arc : found->arcs) time = bent(arc.value, time);
      EXPECT_EQ(time, found->arrival) << "the path takes what is said";
    }
  }
}

}  // namespace
}  // namespace thalweg::testing
