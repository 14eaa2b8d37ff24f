// SPDX-License-Identifier: Apache-2.0
#include "traffic/departures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/queueing.hpp"

namespace thalweg::testing {
namespace {

//     A---B---C      Somebody wants to depart every 100 s, from 0 s on; what departs before 300 s is repeated
//                    after 300 s.
class DeparturesTest : public ::testing::Test {
 protected:
  void load(std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) driven.load(i, "ABC", static_cast<Millis>(i) * 100'000);
  }
  /// In s, whom they expect until 900 s.
  [[nodiscard]] std::vector<Millis> foreseen(const Departures& departures, Millis now) const {
    std::vector<Millis> times;
    departures.foresee(driven.fleet, now, 900'000, [&](const std::vector<RoadId>& route, Millis time) {
      EXPECT_EQ(route, way(net, "ABC"));
      times.push_back(time / 1000);
    });
    std::sort(times.begin(), times.end());
    return times;
  }

  Network net = ascii_network("A---B---C");
  Driven driven{net, 6};
};

TEST_F(DeparturesTest, OfTheLastMinutesAreRepeatedUntilTheEnd) {
  Departures departures(300'000);
  load(0, 3);
  departures.observe(driven.fleet, 250'000);
  for (std::size_t i = 0; i < 3; ++i) driven.fleet.on_arrived(VehicleId{i});
  EXPECT_EQ(foreseen(departures, 250'000), (std::vector<Millis>{300, 400, 500, 600, 700, 800, 900}));
}

// Of those until 500 s only the first three have departed yet.
TEST_F(DeparturesTest, WhoIsLoadedIsRepeatedAndNotAssumed) {
  Departures departures(300'000);
  load(0, 6);
  departures.observe(driven.fleet, 200'000);
  EXPECT_EQ(foreseen(departures, 200'000), (std::vector<Millis>{600, 700, 800, 900}));
}

TEST_F(DeparturesTest, AreNotAssumedWhenThatIsSwitchedOff) {
  Departures departures(0);
  load(0, 3);
  departures.observe(driven.fleet, 250'000);
  EXPECT_EQ(foreseen(departures, 250'000), std::vector<Millis>{});
}

TEST_F(DeparturesTest, ThatAreKnownTakeThePlaceOfAssumedOnes) {
  Departures departures(300'000);
  std::vector<Departures::Departure> known;
  for (const Millis time : {100'000, 200'000, 450'000, 900'000, 901'000})
    known.push_back({.time = time, .route = way(net, "ABC")});
  departures.know(known);
  load(0, 3);  // until 200 s: these are loaded
  departures.observe(driven.fleet, 250'000);
  EXPECT_EQ(foreseen(departures, 200'000), (std::vector<Millis>{450, 900}));
}

}  // namespace
}  // namespace thalweg::testing
