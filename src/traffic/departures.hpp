// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <functional>
#include <utility>
#include <vector>

#include "traffic/fleet.hpp"

namespace thalweg {

/// Who departs after those that SUMO has loaded: known from elsewhere, or assumed to be those of the last
/// minutes again.
class Departures {
 public:
  struct Departure {
    Millis time;
    std::vector<RoadId> route;
  };
  /// Departures of so much of the past are repeated; 0: none.
  explicit Departures(Millis repeated) : repeated_(repeated) {}

  /// By time: they are known, and none is assumed.
  void know(std::vector<Departure> departures) { known_ = std::move(departures); }
  /// Notes who departs. At every look.
  void observe(const Fleet& fleet, Millis now);

  using Take = std::function<void(const std::vector<RoadId>& route, Millis time)>;
  /// Hands over everybody who departs until then. The routes last until the next look.
  void foresee(const Fleet& fleet, Millis now, Millis until, const Take& take) const;

 private:
  void repeat(const Fleet& fleet, Millis loaded_until, Millis now, Millis until, const Take& take) const;

  Millis repeated_;
  std::vector<Departure> known_;
  std::deque<Departure> recent_;
  Millis noted_until_ = -1;
};

}  // namespace thalweg
