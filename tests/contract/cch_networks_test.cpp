// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "graph/road_graph.hpp"
#include "network/read_network.hpp"
#include "routing/strategy.hpp"
#include "support/cch_oracle.hpp"

namespace thalweg::testing {
namespace {

namespace fs = std::filesystem;

/// A net that is tried.
struct Place {
  std::string name;
  fs::path file;
};
std::ostream& operator<<(std::ostream& out, const Place& place) { return out << place.name; }

std::vector<Place> places() {
  const fs::path project = THALWEG_PROJECT_FOLDER;
  const char* const named = std::getenv("THALWEG_CITIES");
  const fs::path cities = named != nullptr ? fs::path(named) : project.parent_path() / "shared" / "cities";
  return {{"grid", project / "networks/grid.net.xml.gz"},
          {"random", project / "networks/random.net.xml.gz"},
          {"spider", project / "networks/spider.net.xml.gz"},
          {"twin", project / "networks/twin.net.xml.gz"},
          {"acosta", cities / "bologna-acosta/acosta_buslanes.net.xml"},
          {"joined", cities / "bologna-joined/joined_buslanes.net.xml"},
          {"wildau", cities / "wildau/Netzmodell2.net.xml.gz"},
          {"luxembourg", cities / "luxembourg/luxembourg.net.xml.gz"}};
}

enum class Mood { free_flow, jammed, random, zero_heavy };

std::vector<Millis> costs_in(Mood mood, const std::vector<Millis>& free_flow, Dice& dice) {
  std::vector<Millis> costs = free_flow;
  for (Millis& cost : costs) {
    if (mood == Mood::free_flow || cost >= infinity) continue;
    if (mood == Mood::jammed && dice.roll(3) == 0) cost *= 1'000;
    if (mood == Mood::random) cost = static_cast<Millis>(dice.roll(100'000));
    if (mood == Mood::zero_heavy && dice.roll(2) == 0) cost = 0;
  }
  return costs;
}

class CchOnNetworks : public ::testing::TestWithParam<Place> {
 protected:
  void SetUp() override {
    if (!fs::exists(GetParam().file)) {
      GTEST_SKIP() << "no net '" << GetParam().file.string() << "': set THALWEG_CITIES";
    }
  }
};

TEST_P(CchOnNetworks, CostsAreDijkstrasInEveryMood) {
  const Network network = read_network(GetParam().file);
  CchOracle<std::uint32_t> narrow;
  CchOracle<std::uint64_t> wide;
  for (const auto vehicle_class : {VehicleClass::passenger, VehicleClass::bus, VehicleClass::bicycle}) {
    const RoadGraph graph(network, vehicle_class);
    if (graph.turns().arc_count() == 0) continue;
    std::vector<Millis> free_flow;
    turn_costs(graph, free_flow_times(network, vehicle_class, default_max_speed(vehicle_class), {}),
               free_flow);
    const CchTopology topology(graph.turns(), nested_dissection(graph.turns()));
    Dice dice(5);
    for (const Mood mood : {Mood::free_flow, Mood::jammed, Mood::random, Mood::zero_heavy}) {
      SCOPED_TRACE(::testing::Message()
                   << "class " << static_cast<int>(vehicle_class) << ", metric " << static_cast<int>(mood));
      const Instance instance{.graph = graph.turns(), .costs = costs_in(mood, free_flow, dice)};
      const auto destinations = some_vertices(graph.turns(), 20, dice);
      const auto origins = some_vertices(graph.turns(), 50, dice);
      if (fits_32_bits(instance.graph, instance.costs)) {
        narrow.check(topology, instance, destinations, origins);
      } else {
        wide.check(topology, instance, destinations, origins);
      }
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GT(narrow.reached + wide.reached, 1'000U);
}

INSTANTIATE_TEST_SUITE_P(AllNets, CchOnNetworks, ::testing::ValuesIn(places()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace thalweg::testing
