// SPDX-License-Identifier: Apache-2.0
#include "traffic/bookings.hpp"

#include <gtest/gtest.h>

#include "support/queueing.hpp"
#include "traffic/queue_forecast.hpp"

namespace thalweg::testing {
namespace {

//     A---B---C---D      300 m roads at 10 m/s: 30 s; a lane lets one pass in 2 s, ten in a bin of 20 s
class BookingsTest : public ::testing::Test {
 protected:
  void forecast(const Driven& driven) { queues.run(driven.fleet, Level(net), 0); }
  /// How much longer than forecast.
  [[nodiscard]] double more(std::size_t bin) const {
    const RoadId ab = road(net, "AB");
    return static_cast<double>(bookings.wait(ab, bin) - table.wait(ab, bin));
  }
  void book(double time, double count) {
    bookings.book(road(net, "AB"), time, count);
    static_cast<void>(bookings.take_changed());
  }

  Network net = ascii_network("A---B---C---D");
  Servers servers{net};
  Discharge discharge{net, servers, crowd(30)};
  QueueForecast queues{net, servers, discharge, {.repeated = 0}};
  const QueueTable& table = queues.table();
  Bookings bookings{net, table};
};

// Thirty stand there for a minute. Six more in the first bin: 12 s more for those who come after them, until
// the minute is over, when the lane has time for them.
TEST_F(BookingsTest, PlacesInAQueueHoldUpThoseBehind) {
  forecast(crowded(net, 30));
  ASSERT_GT(table.queue(road(net, "AB"), 1), 0);
  ASSERT_EQ(table.queue(road(net, "AB"), 4), 0);
  book(5, 6);
  EXPECT_NEAR(more(0), 6, 0.1) << "half of them are before one in the middle of the bin";
  EXPECT_NEAR(more(1), 12, 0.1);
  EXPECT_NEAR(more(2), 12, 0.1);
  EXPECT_NEAR(more(6), 0, 0.1);
}

// Where nobody queues, ten a bin find time; of twenty, half wait into the next bin, which has time for them.
TEST_F(BookingsTest, AFreeRoadHasRoom) {
  forecast(Driven(net, 1));
  book(45, 10);
  EXPECT_NEAR(more(2), 0, 0.1);
  EXPECT_NEAR(more(3), 0, 0.1);
  book(45, 10);
  EXPECT_NEAR(more(2), 10, 0.1);
  EXPECT_NEAR(more(3), 10, 0.1);
  EXPECT_NEAR(more(4), 0, 0.1);
}

TEST_F(BookingsTest, PlacesAreGivenBack) {
  forecast(crowded(net, 30));
  book(5, -6);
  EXPECT_NEAR(more(1), -12, 0.1);
  book(5, 6);
  for (std::size_t bin = 0; bin < 60; ++bin) EXPECT_EQ(more(bin), 0) << bin;
  book(5, -1000);
  for (std::size_t bin = 0; bin < 60; ++bin) EXPECT_GE(bookings.wait(road(net, "AB"), bin), 0) << bin;
}

TEST_F(BookingsTest, TheNextForecastKnowsThem) {
  forecast(crowded(net, 30));
  book(5, 6);
  bookings.book(road(net, "BC"), 1'000'000, 1);  // beyond the horizon
  EXPECT_TRUE(bookings.take_changed().empty());
  bookings.clear();
  EXPECT_EQ(more(1), 0);
}

}  // namespace
}  // namespace thalweg::testing
