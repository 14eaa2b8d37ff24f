// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "traffic/fleet.hpp"
#include "traffic/servers.hpp"

namespace thalweg {

struct InsertionOptions {
  Millis interval = 120'000;    ///< between two lessons
  double headway = 2;           ///< s between two on an empty lane
  double slowest = 60;          ///< s between two of a line
  double towards_slower = 0.5;  ///< share of the way to what was seen
  double towards_usual = 0.1;   ///< the same where nobody waits any more
  double kept = 0.9;            ///< of what was seen to be waited, a lesson later
};

/// The lines of those who wait to get on their first road, each in the order of its departures, and how fast
/// they move, learned while the run goes on. Turns that share a lane of the road share a line. Where a turn
/// has its lanes for itself, SUMO inserts those who make it past those who wait for the other lanes.
class Insertions {
 public:
  Insertions(const Network& network, const Servers& servers, std::size_t vehicles,
             const InsertionOptions& options = {});

  /// After every look at the traffic.
  void observe(const Fleet& fleet, Millis now);

  /// The line of those who drive on to the next road; where no lane leads there, or `next` is invalid (the
  /// trip ends on the road), the first one of the road. Named by one of its lanes.
  [[nodiscard]] LaneId line(RoadId road, RoadId next) const;
  [[nodiscard]] bool has_one_line(RoadId road) const { return has_one_line_[road]; }
  [[nodiscard]] double headway(LaneId line) const { return lines_[line].headway; }  ///< s between two
  /// s that those have waited who got in lately, in the mean; nothing where there was nobody.
  [[nodiscard]] std::optional<double> wait(LaneId line) const;

 private:
  struct Line {
    double usual_headway = 0;  ///< s, while nobody has waited yet
    double headway = 0;        ///< s
    int waiting = 0;           ///< at this look
    int busy_looks = 0;
    int inserted = 0;   ///< since the last lesson
    double seen = 0;    ///< vehicles that got in lately
    double waited = 0;  ///< s, these together
  };
  void form_lines(const Network& network, RoadId road);
  void learn(Line& line, double seconds) const;

  const Servers& servers_;
  InsertionOptions options_;
  IdVector<LaneId, Line> lines_;  ///< by their names
  IdVector<LaneId, LaneId> line_of_;
  IdVector<RoadId, LaneId> first_;
  IdVector<RoadId, bool> has_one_line_;
  IdVector<VehicleId, bool> is_in_;
  std::vector<LaneId> wanted_;  ///< lines with waiting vehicles at this look
  int looks_ = 0;
  Millis last_look_ = -1;
  Millis last_lesson_ = -1;
};

}  // namespace thalweg
