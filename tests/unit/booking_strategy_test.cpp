// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "simulation/control.hpp"
#include "support/fake_simulation.hpp"

namespace thalweg::testing {
namespace {

//     Q           A vehicle a second comes from P and Q together; the ends of AB and of AC let one pass in 2
//     s. |           All 60 mean to go by B, where a queue is to be expected.
//   P-A-B
//     | |
//     C-D-T
class SharedBottleneck : public ::testing::Test {
 protected:
  /// How many of them go by C after everybody has decided once.
  [[nodiscard]] std::size_t by_c(std::string_view strategy, std::size_t threads) const {
    std::vector<FakeVehicle> vehicles;
    for (std::size_t i = 0; i < 60; ++i) {
      vehicles.push_back({.id = fmt::format("v{}", i),
                          .depart = static_cast<Millis>(i) * 1000,
                          .route = way(net, i % 2 == 0 ? "PABDT" : "QABDT")});
    }
    FakeSimulation simulation(net, vehicles, {.end = 1'000});
    const auto own = make_strategy(
        strategy, {.rule = {.relative = 0, .spread = 0, .absolute = 1'000}, .threads = threads});
    const std::atomic<bool> stop = false;
    control(simulation, net, simulation.demand(), own.get(), {.period = 0}, {}, stop);
    const RoadId ac = road(net, "AC");
    std::size_t count = 0;
    for (const Assignment& assignment : simulation.assignments)
      count += static_cast<std::size_t>(std::count(assignment.route.begin(), assignment.route.end(), ac));
    return count;
  }

  Network net = ascii_network("  Q\n  |\nP-A-B\n  | |\n  C-D-T");
};

TEST_F(SharedBottleneck, WhoDecidesAloneGoesWhereEverybodyGoes) { EXPECT_GT(by_c("forecast", 1), 45U); }

TEST_F(SharedBottleneck, WhoSeesWhatOthersBookedSpreads) {
  const std::size_t count = by_c("booking", 1);
  EXPECT_GT(count, 5U);
  EXPECT_LT(count, 30U) << "until the others have no queue to leave";
}

TEST_F(SharedBottleneck, BookingsDoNotDependOnThreads) { EXPECT_EQ(by_c("booking", 1), by_c("booking", 2)); }

}  // namespace
}  // namespace thalweg::testing
