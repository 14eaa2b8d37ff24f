// SPDX-License-Identifier: Apache-2.0
#include "traffic/until_arrival.hpp"

#include <gtest/gtest.h>

#include "support/queueing.hpp"
#include "traffic/fading.hpp"

namespace thalweg::testing {
namespace {

TEST(UntilArrival, HandsOverWhatIsKeptOfThoseWhoHaveArrivedOnce) {
  const Network net = ascii_network("A-B-C");
  Driven driven{net, 3};
  UntilArrival<int> kept(3);
  for (std::size_t i = 0; i < 3; ++i) {
    driven.load(i, "ABC");
    kept[VehicleId{2 - i}] = static_cast<int>(2 - i);
  }
  kept[VehicleId{2U}] += 10;
  driven.fleet.on_arrived(VehicleId{0U});
  driven.fleet.on_arrived(VehicleId{2U});
  std::vector<int> settled;
  const auto settle = [&] { kept.settle(driven.fleet, [&](int one) { settled.push_back(one); }); };
  settle();
  EXPECT_EQ(settled, (std::vector{12, 0}));  // in the order in which they were begun
  EXPECT_TRUE(kept.contains(VehicleId{1U}));
  EXPECT_FALSE(kept.contains(VehicleId{2U}));
  settle();
  EXPECT_EQ(settled.size(), 2U);
  EXPECT_EQ(kept[VehicleId{2U}], 0);  // as new
}

TEST(Fading, LeavesTheSameWhateverTheSteps) {
  Fading once(100);
  Fading twice(100);
  const double first = twice.advance(30'000);
  EXPECT_NEAR(once.advance(100'000), std::exp(-1.0), 1e-12);
  EXPECT_NEAR(first * twice.advance(100'000), std::exp(-1.0), 1e-12);
}

}  // namespace
}  // namespace thalweg::testing
