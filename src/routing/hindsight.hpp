// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "traffic/fading.hpp"
#include "traffic/until_arrival.hpp"

namespace thalweg {

struct HindsightOptions {
  double memory = 1200;  ///< s after which what was seen counts 1/e
  double first = 0.3;    ///< share of the promised gain that is believed in before anything was seen
  double prior = 30;     ///< arrivals that this is worth
  double unseen = 0.1;   ///< disappointment before anything was seen, as a share of the time left
  double enough = 0.5;   ///< share of the promised gain that is a reason to go on as before
};

/// What became of the promises. Who changes its way for the best of several uncertain forecasts is
/// disappointed on average (the winner's curse: Capen, Clapp, Campbell 1971): that best is the one whose
/// error was the most favourable. Whether this is so in this city at this hour shows when vehicles arrive:
/// those that changed against those that kept their way, each by the time that was forecast for it. Where
/// changing brings next to nothing, fewer are to change, down to none. Who changes for the others' sake
/// (tolls) is promised little, and counts by that.
class Hindsight {
 public:
  explicit Hindsight(std::size_t vehicles, const HindsightOptions& options = {});

  /// A vehicle has decided at `now`, by the arrivals forecast for its old way and for the best new one (the
  /// old again: there is no better). What counts is its last change, else its first decision.
  void decided(VehicleId vehicle, Millis now, Millis old_arrival, Millis new_arrival, bool changed);
  /// After every look at the traffic: who has arrived?
  void observe(const Fleet& fleet, Millis now);

  /// Share of the promised gain that those had who changed, were their old ways as much longer than forecast
  /// as those of the others. Below 0: they lost. `first` before anybody has arrived.
  [[nodiscard]] double realised() const;
  /// What a gain must exceed on top: as a share of the time left, by how much those before were disappointed;
  /// 0 where `enough` was realised, and all of it where nothing was.
  [[nodiscard]] double caution() const;

 private:
  struct Promise {
    Millis made = 0;
    Millis old_arrival = 0;
    Millis new_arrival = 0;
    bool changed = false;
  };
  struct Account {
    double old_way = 0;  ///< s, forecast
    double new_way = 0;  ///< s, forecast
    double taken = 0;    ///< s
    double arrivals = 0;
    [[nodiscard]] double promised() const { return old_way - new_way; }  ///< s; 0 before the first arrival
    [[nodiscard]] double ratio(double prior) const;                      ///< taken / forecast
  };

  HindsightOptions options_;
  Fading fading_;
  UntilArrival<Promise> promises_;
  Account changed_;
  Account kept_;
};

}  // namespace thalweg
