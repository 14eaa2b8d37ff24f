// SPDX-License-Identifier: Apache-2.0
#include "routing/cch_engine.hpp"

#include <gtest/gtest.h>

#include "support/random_graph.hpp"

namespace thalweg::testing {
namespace {

/// `count` travellers on a graph, `per_end` to each destination.
std::vector<Traveller> travellers(const Digraph& graph, std::size_t count, std::size_t per_end, Dice& dice) {
  std::vector<Traveller> due(count);
  VertexId end;
  for (std::size_t i = 0; i < count; ++i) {
    if (i % per_end == 0) end = VertexId{dice.roll(graph.vertex_count())};
    due[i].route = {VertexId{dice.roll(graph.vertex_count())}};
    due[i].waypoints = {end};
  }
  return due;
}

struct Found {
  Millis cost;
  std::vector<VertexId> roads;
  bool operator==(const Found&) const = default;
};

std::vector<Found> serve(CchEngine& engine, const Instance& instance, const std::vector<Traveller>& due,
                         std::optional<CchMethod> method = std::nullopt) {
  Legs legs;
  legs.collect(due);
  engine.serve(instance.graph, instance.costs, legs, 0, legs.group_count(), method);
  std::vector<Found> found;
  for (std::size_t g = 0; g < legs.group_count(); ++g) {
    for (const Leg& leg : legs.group(g)) found.push_back({.cost = leg.cost, .roads = leg.roads});
  }
  return found;
}

// Costs above zero: then the way does not depend on the method.
TEST(CchEngine, EveryMethodFindsTheSameWays) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Instance instance = random_grid(12, seed, 30);
    Dice dice(seed);
    const bool is_wide = seed % 4 == 3;
    for (Millis& cost : instance.costs) {
      if (is_wide) cost *= 100'000'000;
      if (dice.roll(9) == 0) cost = infinity;
    }
    const auto due = travellers(instance.graph, 60, 1 + seed % 7, dice);
    CchEngine first(1, {});
    const auto expected = serve(first, instance, due, CchMethod::trees);
    for (const auto method : {CchMethod::hierarchy, CchMethod::sweeps, CchMethod::lone_searches}) {
      for (const std::size_t threads : {1U, 2U, 4U}) {
        CchEngine engine(threads, {});
        EXPECT_EQ(serve(engine, instance, due, method), expected) << "method " << static_cast<int>(method);
      }
    }
  }
}

TEST(CchEngine, NoticesNewCostsAndANewGraphAtTheSameAddress) {
  CchEngine engine(1, {});
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Instance instance = random_grid(5 + seed / 2, seed, 30);
    Dice dice(seed);
    const auto due = travellers(instance.graph, 20, 2, dice);
    CchEngine fresh(1, {});
    EXPECT_EQ(serve(engine, instance, due, CchMethod::hierarchy),
              serve(fresh, instance, due, CchMethod::trees));
    for (Millis& cost : instance.costs) cost = 31 - cost;
    CchEngine again(1, {});
    EXPECT_EQ(serve(engine, instance, due, CchMethod::hierarchy),
              serve(again, instance, due, CchMethod::trees));
  }
}

TEST(CchEngine, BuildsAHierarchyOnceTreesHaveCostAsMuch) {
  const Instance instance = random_grid(20, 1, 30);
  CchEngine engine(1, {});
  Dice dice(1);
  serve(engine, instance, travellers(instance.graph, 1, 1, dice));
  EXPECT_EQ(engine.topology(), nullptr) << "one way is not worth it";
  serve(engine, instance, travellers(instance.graph, 500, 1, dice));
  EXPECT_NE(engine.topology(), nullptr);
}

TEST(CchEngine, AnEmptyBatchAndAGraphOfOneRoad) {
  CchEngine engine(1, {});
  const Instance one = make_instance(1, {{0, 0, 5}});
  EXPECT_TRUE(serve(engine, one, {}).empty());
  Traveller traveller;
  traveller.route = {VertexId{0}};
  traveller.waypoints = {VertexId{0}};
  for (const auto method : {CchMethod::trees, CchMethod::sweeps, CchMethod::lone_searches}) {
    const auto found = serve(engine, one, {traveller}, method);
    EXPECT_EQ(found.front().cost, 0);
    EXPECT_TRUE(found.front().roads.empty());
  }
}

}  // namespace
}  // namespace thalweg::testing
