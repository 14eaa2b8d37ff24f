// SPDX-License-Identifier: Apache-2.0
#include "simulation/forecast_error.hpp"

#include <algorithm>
#include <cmath>

namespace thalweg {
namespace {

void add(ErrorSums& sums, Millis predicted, Millis realised) {
  const double difference = to_seconds(predicted - realised);
  sums.absolute += std::abs(difference);
  sums.difference += difference;
}

}  // namespace

HorizonError& HorizonError::operator+=(const HorizonError& other) {
  predictions += other.predictions;
  realised += other.realised;
  own.absolute += other.own.absolute;
  own.difference += other.own.difference;
  measured.absolute += other.measured.absolute;
  measured.difference += other.measured.difference;
  return *this;
}

void PredictionLedger::predicted(VehicleId vehicle, Millis now, Millis arrival, Millis measured_arrival) {
  if (arrival >= infinity || measured_arrival >= infinity) return;
  open_[vehicle].push_back({.made = now, .arrival = arrival, .measured_arrival = measured_arrival});
}

void PredictionLedger::arrived(VehicleId vehicle, Millis now) {
  for (const Prediction& prediction : open_[vehicle]) {
    const auto next = std::upper_bound(horizons.begin() + 1, horizons.end(), now - prediction.made);
    HorizonError& error = out_[static_cast<std::size_t>(next - horizons.begin()) - 1];
    ++error.predictions;
    error.realised += to_seconds(now - prediction.made);
    add(error.own, prediction.arrival, now);
    add(error.measured, prediction.measured_arrival, now);
  }
  open_[vehicle] = {};
}

}  // namespace thalweg
