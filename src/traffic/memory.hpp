// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/time.hpp"
#include "network/network.hpp"
#include "traffic/lived_times.hpp"

namespace thalweg {

/// The time that a road took at one time of day, over the days.
struct RememberedTime {
  RoadId road;
  double seconds = 0;
  double observations = 0;  ///< traversals, of all days
  std::size_t days = 0;     ///< on which somebody drove there at that time
};

/// Who set out where, on the day whose ways are kept.
struct RememberedTrip {
  std::string vehicle;
  Millis depart = 0;            ///< as demanded
  std::vector<RoadId> route{};  ///< on which it set out
};

/// What a crew remembers of the days before and shares at once (the paper's memory): the time that was lived
/// on each road at each time of day, and who set out where.
///
/// Days are smoothed by successive averages: the n-th day on which a road was driven moves its time by 1/n of
/// the difference (Robbins, Monro 1951; Sheffi, Powell 1982), later by a constant, since the city changes.
struct Memory {
  Millis bin = 90'000;  ///< of the time of day
  std::size_t days = 0;
  /// By bin; roads in order. For SUMO's tools (duarouter --weight-files): no decision goes by it.
  std::vector<std::vector<RememberedTime>> times{};
  std::vector<RememberedTrip> trips{};  ///< in the order of their departures
  double commute = 0;                   ///< s: of these trips, in the mean

  /// What a new day counts at least against all those before.
  static constexpr double least_step = 0.2;

  /// What a day that was worse moves the expectation of the ways that are kept.
  static constexpr double doubt = 0.2;

  /// Takes in a day: its lived times by bin (roads in order), and everybody's trip in place of those before
  /// if that day was better. Ways of a day that was merely lucky do not stay: each day that is worse than
  /// they promised makes them look worse (evolution by one parent and one child, cf. Rechenberg 1973, with a
  /// parent that is judged again).
  void learn(const std::vector<std::vector<LivedTime>>& day, std::vector<RememberedTrip> new_trips,
             double new_commute);
};

}  // namespace thalweg
