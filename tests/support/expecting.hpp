// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <utility>

#include "support/queueing.hpp"
#include "traffic/queue_forecast.hpp"
#include "traffic/timed_costs.hpp"

namespace thalweg::testing {

//     A---B---C---D      30 s each, 2 s a vehicle
/// All that costs are made of, learned from nothing yet; of this net or another.
class Expecting : public ::testing::Test {
 protected:
  explicit Expecting(Network network = ascii_network("A---B---C---D")) : net(std::move(network)) {}

  [[nodiscard]] Expectation expected(const Conditions& conditions) const {
    return {.forecast = table,
            .bookings = bookings,
            .servers = servers,
            .level = level,
            .residuals = residuals,
            .conditions = conditions};
  }

  Network net;
  Servers servers{net};
  Level level{net};
  Residuals residuals{net};
  Discharge discharge{net, servers, crowd(40)};
  QueueForecast queues{net, servers, discharge, {.repeated = 0}};
  const QueueTable& table = queues.table();
  Bookings bookings{net, table};
  Conditions unchanged{net};
};

}  // namespace thalweg::testing
