// SPDX-License-Identifier: Apache-2.0
#include "simulation/forecast_error.hpp"

#include <gtest/gtest.h>

namespace thalweg {
namespace {

constexpr VehicleId first{0U};
constexpr VehicleId second{1U};

TEST(PredictionLedger, HoldsEachPredictionAgainstTheArrival) {
  ForecastError errors{};
  PredictionLedger ledger(2, errors);
  ledger.predicted(first, 0, 280'000, 400'000);
  ledger.predicted(first, 100'000, 310'000, 290'000);
  ledger.predicted(second, 200'000, 400'000, 400'000);  // it will take five minutes: of the next horizon
  ledger.arrived(first, 290'000);
  EXPECT_EQ(errors[0].predictions, 2U);
  EXPECT_DOUBLE_EQ(errors[0].realised, 290 + 190);
  EXPECT_DOUBLE_EQ(errors[0].own.absolute, 10 + 20);
  EXPECT_DOUBLE_EQ(errors[0].own.difference, -10 + 20);
  EXPECT_DOUBLE_EQ(errors[0].measured.absolute, 110 + 0);
  EXPECT_DOUBLE_EQ(errors[0].measured.difference, 110 + 0);
  EXPECT_EQ(errors[1].predictions, 0U) << "it is still on its way";
  ledger.arrived(second, 500'000);
  EXPECT_EQ(errors[1].predictions, 1U);
  EXPECT_DOUBLE_EQ(errors[1].own.difference, -100);
  ledger.arrived(first, 900'000);
  EXPECT_EQ(errors[0].predictions, 2U) << "they count once";
}

TEST(PredictionLedger, AChangeOfWayMakesThoseBeforeMoot) {
  ForecastError errors{};
  PredictionLedger ledger(1, errors);
  ledger.predicted(first, 0, 100'000, 100'000);
  ledger.changed_way(first);
  ledger.predicted(first, 10'000, 2'000'000, 90'000);
  ledger.predicted(first, 20'000, infinity, 90'000);
  ledger.arrived(first, 80'000);
  EXPECT_EQ(errors[0].predictions, 1U) << "never is no prediction";
  EXPECT_DOUBLE_EQ(errors[0].own.absolute, 1'920);
  EXPECT_DOUBLE_EQ(errors[0].measured.absolute, 10);
  EXPECT_EQ(errors[3].predictions, 0U) << "a far prediction of what is near is one of the near";
}

}  // namespace
}  // namespace thalweg
