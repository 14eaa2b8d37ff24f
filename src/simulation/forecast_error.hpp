// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/id.hpp"
#include "core/time.hpp"
#include "demand/demand.hpp"

namespace thalweg {

/// Sums over predictions, in s: predicted less realised.
struct ErrorSums {
  double absolute = 0;
  double difference = 0;
};

/// The predictions of one horizon, held against what came. `own`: of the router in charge; `measured`: what
/// the live travel times would have said of the same vehicle on the same way at the same moment.
struct HorizonError {
  std::uint64_t predictions = 0;
  double realised = 0;  ///< s, sum of the times that were really left
  ErrorSums own{};
  ErrorSums measured{};

  /// Of a sum; NaN of nothing.
  [[nodiscard]] double mean(double sum) const { return sum / static_cast<double>(predictions); }
  HorizonError& operator+=(const HorizonError& other);
};

/// By the time that was really left: from each of these up to the next. Not by what the router predicted:
/// its too long predictions would be gathered in the far horizons, where the other's are not looked for.
inline constexpr std::array<Millis, 4> horizons{0, 300'000, 600'000, 1'200'000};
using ForecastError = std::array<HorizonError, horizons.size()>;

/// Holds the predicted arrivals of the vehicles on their way until they are there. Every decision's
/// prediction for the way then chosen counts, unless the vehicle changed its way later, which makes it moot,
/// or did not arrive. That selects: predictions that proved too hopeful on the way are the ones that make
/// vehicles change, so that both errors come out smaller than they are, and the error of the router in charge
/// more so than that of the measured times, which nobody acted upon.
class PredictionLedger {
 public:
  PredictionLedger(std::size_t vehicles, ForecastError& out) : open_(vehicles), out_(out) {}

  /// What was predicted for the vehicle until now is moot.
  void changed_way(VehicleId vehicle) { open_[vehicle].clear(); }
  /// Arrivals predicted at `now`; those that are never are left out.
  void predicted(VehicleId vehicle, Millis now, Millis arrival, Millis measured_arrival);
  void arrived(VehicleId vehicle, Millis now);

 private:
  struct Prediction {
    Millis made = 0;
    Millis arrival = 0;
    Millis measured_arrival = 0;
  };

  IdVector<VehicleId, std::vector<Prediction>> open_;
  ForecastError& out_;
};

}  // namespace thalweg
