// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "contract/search_contract.hpp"
#include "search/dijkstra.hpp"
#include "search/evolve.hpp"
#include "search/hybrid.hpp"
#include "search/regions.hpp"

namespace thalweg::testing {
namespace {

constexpr std::uint64_t seeds_per_type = 2'000;
constexpr InstanceType all_types[] = {InstanceType::mixed, InstanceType::simple, InstanceType::directed};

// The adapters keep their trees and scratch from one call to the next, as the program does: what is left over
// from another graph must not show.

template <Direction direction>
std::vector<Answer> answers(const Digraph& graph, const Tree& tree, std::span<const VertexId> wanted) {
  std::vector<Answer> out;
  for (const VertexId v : wanted)
    out.push_back({.label = tree.label[v], .path = path<direction>(graph, tree, v)});
  return out;
}

template <Direction direction>
SearchUnderTest hybrid_search(const std::string& name) {
  return {.name = name,
          .direction = direction,
          .exact = false,
          .run = [regions = Regions{}, tree = Tree{}](const Instance& instance, VertexId root,
                                                      std::span<const VertexId> wanted, Stop stop) mutable {
            const auto until = stop == Stop::when_found ? wanted : std::span<const VertexId>{};
            partition<direction>(instance.graph, std::span(&root, 1), regions, until);
            hybrid<direction>(instance.graph, regions, instance, tree);
            return answers<direction>(instance.graph, tree, wanted);
          }};
}

template <Direction direction>
SearchUnderTest evolved_search(const std::string& name) {
  return {.name = name,
          .direction = direction,
          .exact = true,
          .run = [regions = Regions{}, tree = Tree{}, scratch = EvolveScratch{}](
                     const Instance& instance, VertexId root, std::span<const VertexId> wanted,
                     Stop stop) mutable {
            const auto targets = stop == Stop::when_found ? wanted : std::span<const VertexId>{};
            partition<direction>(instance.graph, std::span(&root, 1), regions, targets);
            hybrid<direction>(instance.graph, regions, instance, tree);
            const Evolution done =
                evolve<direction>(instance.graph, regions, instance, tree, scratch, {}, targets);
            EXPECT_TRUE(done.settled);
            return answers<direction>(instance.graph, tree, wanted);
          }};
}

template <Direction direction>
SearchUnderTest dijkstra_search(const std::string& name) {
  return {.name = name,
          .direction = direction,
          .exact = true,
          .run = [tree = Tree{}, scratch = DijkstraScratch{}](const Instance& instance, VertexId root,
                                                              std::span<const VertexId> wanted,
                                                              Stop stop) mutable {
            const auto targets = stop == Stop::when_found ? wanted : std::span<const VertexId>{};
            dijkstra<direction>(instance.graph, std::span(&root, 1), instance, tree, scratch, targets);
            return answers<direction>(instance.graph, tree, wanted);
          }};
}

std::vector<VertexId> all_vertices(const Digraph& graph) {
  std::vector<VertexId> vertices;
  for (std::size_t i = 0; i < graph.vertex_count(); ++i) vertices.emplace_back(i);
  return vertices;
}

VertexId any_vertex(const Digraph& graph, Dice& dice) { return VertexId{dice.roll(graph.vertex_count())}; }

/// The answer's path leads between root and vertex over connected arcs and costs what the label says.
void expect_sound(const Instance& instance, Direction direction, VertexId root, VertexId vertex,
                  const Answer& answer) {
  ASSERT_EQ(answer.path.has_value(), answer.label < infinity) << "vertex " << vertex.value;
  if (!answer.path) return;
  VertexId at = direction == Direction::forward ? root : vertex;
  Millis cost = 0;
  for (const ArcId arc : *answer.path) {
    ASSERT_EQ(instance.graph.ends(arc).tail, at) << "arc " << arc.value << " does not follow";
    at = instance.graph.ends(arc).head;
    cost = add_saturating(cost, instance(arc));
  }
  EXPECT_EQ(at, direction == Direction::forward ? vertex : root);
  EXPECT_EQ(cost, answer.label) << "vertex " << vertex.value;
}

class SearchContract : public ::testing::TestWithParam<SearchUnderTest> {
 protected:
  /// Calls `check(instance, seed)` with every random instance; the messages of what fails name it.
  template <class Check>
  void for_every_instance(Check check) {
    for (const InstanceType type : all_types) {
      for (std::uint64_t seed = 0; seed < seeds_per_type; ++seed) {
        SCOPED_TRACE(::testing::Message() << "type " << static_cast<int>(type) << " seed " << seed);
        check(random_instance(type, seed), seed);
        if (HasFatalFailure() || HasNonfatalFailure()) return;
      }
    }
  }
};

TEST_P(SearchContract, PathsAreConnectedAndCostTheirLabel) {
  std::size_t paths = 0;
  std::size_t unreachable = 0;
  for_every_instance([&](const Instance& instance, std::uint64_t seed) {
    Dice dice(seed);
    const VertexId root = any_vertex(instance.graph, dice);
    const auto wanted = all_vertices(instance.graph);
    const auto found = GetParam().run(instance, root, wanted, Stop::at_the_end);
    for (const VertexId v : wanted) {
      expect_sound(instance, GetParam().direction, root, v, found[v.value]);
      ++(found[v.value].path ? paths : unreachable);
    }
  });
  EXPECT_GT(paths, 10'000U);
  EXPECT_GT(unreachable, 10'000U);
}

TEST_P(SearchContract, NeverBelowTheLeastCostAndExactWhereItClaimsToBe) {
  std::size_t above = 0;
  for_every_instance([&](const Instance& instance, std::uint64_t seed) {
    Dice dice(seed);
    const VertexId root = any_vertex(instance.graph, dice);
    const auto wanted = all_vertices(instance.graph);
    const auto least = least_costs(instance, root, GetParam().direction);
    const auto found = GetParam().run(instance, root, wanted, Stop::at_the_end);
    for (const VertexId v : wanted) {
      EXPECT_GE(found[v.value].label, least[v.value]) << "vertex " << v.value;
      above += found[v.value].label > least[v.value] ? 1U : 0U;
    }
  });
  if (GetParam().exact) {
    EXPECT_EQ(above, 0U);
  } else {
    EXPECT_GT(above, 1'000U) << "anti events are missing: the instances test nothing";
  }
}

// One to three wanted vertices, so that there is something to leave out; a repeated one and the root among
// them.
TEST_P(SearchContract, StoppingWhenFoundChangesNoAnswer) {
  for_every_instance([&](const Instance& instance, std::uint64_t seed) {
    Dice dice(seed);
    const VertexId root = any_vertex(instance.graph, dice);
    std::vector<VertexId> wanted;
    for (std::size_t i = 0; i <= seed % 3; ++i) wanted.push_back(any_vertex(instance.graph, dice));
    const auto full = GetParam().run(instance, root, wanted, Stop::at_the_end);
    const auto stopped = GetParam().run(instance, root, wanted, Stop::when_found);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      EXPECT_EQ(stopped[i].label, full[i].label) << "vertex " << wanted[i].value;
      expect_sound(instance, GetParam().direction, root, wanted[i], stopped[i]);
    }
  });
}

TEST_P(SearchContract, SourceIsTargetIsTheEmptyPath) {
  for_every_instance([&](const Instance& instance, std::uint64_t) {
    for (const VertexId v : all_vertices(instance.graph)) {
      for (const Stop stop : {Stop::at_the_end, Stop::when_found}) {
        const auto found = GetParam().run(instance, v, std::span(&v, 1), stop);
        EXPECT_EQ(found[0].label, 0);
        ASSERT_TRUE(found[0].path.has_value());
        EXPECT_TRUE(found[0].path->empty());
      }
    }
  });
}

//     0 --5--> 1     2          nothing leads from 2, nor to it
TEST_P(SearchContract, UnreachableIsNoPath) {
  const ArcEnds arcs[] = {{.tail = VertexId{0U}, .head = VertexId{1U}}};
  const Instance instance{.graph = Digraph(3, arcs), .costs = {5}};
  const bool forward = GetParam().direction == Direction::forward;
  const VertexId root{forward ? 0U : 1U};
  const VertexId wanted[] = {VertexId{forward ? 1U : 0U}, VertexId{2U}};
  for (const Stop stop : {Stop::at_the_end, Stop::when_found}) {
    const auto found = GetParam().run(instance, root, wanted, stop);
    EXPECT_EQ(found[0].path, std::vector{ArcId{0U}});
    EXPECT_EQ(found[0].label, 5);
    EXPECT_EQ(found[1].path, std::nullopt);
    EXPECT_EQ(found[1].label, infinity);
    // Against the arc there is no way.
    EXPECT_EQ(GetParam().run(instance, wanted[0], std::span(&root, 1), stop)[0].path, std::nullopt);
  }
}

TEST_P(SearchContract, RunsTwiceAlike) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Instance instance = random_grid(12, seed, 3);  // small costs: many ties
    const auto wanted = all_vertices(instance.graph);
    const auto once = GetParam().run(instance, VertexId{0U}, wanted, Stop::at_the_end);
    const auto other = random_grid(20, seed, 9);
    GetParam().run(other, VertexId{399U}, wanted, Stop::when_found);
    const auto twice = GetParam().run(instance, VertexId{0U}, wanted, Stop::at_the_end);
    for (const VertexId v : wanted) EXPECT_EQ(once[v.value].path, twice[v.value].path) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(EverySearch, SearchContract, ::testing::ValuesIn(searches_under_test()),
                         [](const auto& test) { return test.param.name; });

}  // namespace

std::vector<SearchUnderTest> searches_under_test() {
  return {hybrid_search<Direction::forward>("HybridForward"),
          hybrid_search<Direction::backward>("HybridBackward"),
          evolved_search<Direction::forward>("EvolvedForward"),
          evolved_search<Direction::backward>("EvolvedBackward"),
          dijkstra_search<Direction::forward>("DijkstraForward"),
          dijkstra_search<Direction::backward>("DijkstraBackward")};
}

}  // namespace thalweg::testing
