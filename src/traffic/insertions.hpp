// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "traffic/fleet.hpp"
#include "traffic/servers.hpp"

namespace thalweg {

struct InsertionOptions {
  Millis interval = 120'000;  ///< between two lessons
  double kept = 0.5;          ///< of what was seen of a line in which somebody waits, a lesson later
  double faded = 0.9;         ///< the same of one in which nobody waits any more
  double usual = 2;           ///< insertions that what is usual is worth
};

/// How those get on their first road who wait for it, learned while the run goes on. Those who make the same
/// turn at its end stand in one line, in the order of their departures: SUMO inserts them on the lanes for
/// that turn, where the road has several, past those who wait for other lanes.
class Insertions {
 public:
  Insertions(const Servers& servers, std::size_t vehicles, const InsertionOptions& options = {});

  /// After every look at the traffic.
  void observe(const Fleet& fleet, Millis now);

  /// s between two of a line.
  [[nodiscard]] double headway(MovementId turn) const { return lines_[turn].headway; }
  /// s that those have waited who got in lately, in the mean; nothing where there was nobody.
  [[nodiscard]] std::optional<double> wait(MovementId turn) const;

 private:
  struct Line {
    double usual_headway = 2;  ///< s, while nobody has waited yet
    double headway = 2;        ///< s
    double busy = 0;           ///< s of late in which somebody always waited
    double got_in = 0;         ///< vehicles, in that time
    int waiting = 0;           ///< at this look
    int busy_looks = 0;
    int inserted = 0;   ///< since the last lesson
    double seen = 0;    ///< vehicles that got in of late
    double waited = 0;  ///< s, these together
  };
  void learn(Line& line, double seconds) const;

  const Servers& servers_;
  InsertionOptions options_;
  IdVector<MovementId, Line> lines_;
  IdVector<VehicleId, bool> is_in_;
  std::vector<MovementId> wanted_;  ///< lines with waiting vehicles at this look
  int looks_ = 0;
  Millis last_look_ = -1;
  Millis last_lesson_ = -1;
};

}  // namespace thalweg
