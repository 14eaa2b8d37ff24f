// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "traffic/fleet.hpp"
#include "traffic/insertions.hpp"
#include "traffic/servers.hpp"

namespace thalweg {

struct DischargeOptions {
  Millis interval = 120'000;  ///< between two lessons
  double slow = 5;            ///< m/s: who is slower stands in the queue
  int queue = 2;              ///< so many of them at every look: the lane was never idle
  double least = 0.6;         ///< bounds of the factor
  double most = 4;
  double towards_slower = 0.3;  ///< share of the way to what was seen
  double towards_faster = 0.5;
};

/// What the lanes really let through, learned while the run goes on: a factor on the headways of Servers for
/// every lane; beside it how fast vehicles get on the roads.
/// A lane whose queue never emptied has shown its capacity: factor = time / headways of those that left. One
/// that let more pass than the model allows has shown that it can.
class Discharge {
 public:
  Discharge(const Network& network, const Servers& servers, const Demand& demand,
            const DischargeOptions& options = {});

  /// After every look at the traffic.
  void observe(const Fleet& fleet, Millis now);

  [[nodiscard]] double factor(LaneId lane) const { return lanes_[lane].factor; }
  /// Has the memory fetch it.
  void prefetch(LaneId lane) const { __builtin_prefetch(&lanes_[lane]); }
  [[nodiscard]] const Insertions& insertions() const { return insertions_; }

 private:
  struct LaneState {
    double factor = 1;
    double served = 0;  ///< s: headways of those that left since the last lesson
    int queue = 0;      ///< at this look
    int busy_looks = 0;
  };
  struct Last {
    std::size_t position = 0;
    bool on_junction = false;
    bool seen = false;
    LaneId lane{};
    RoadId road{};
  };
  void note(VehicleId vehicle, const FleetVehicle& now);
  void learn(double seconds);

  const Servers& servers_;
  DischargeOptions options_;
  Insertions insertions_;
  IdVector<LaneId, LaneState> lanes_;
  IdVector<VehicleId, Last> last_;
  std::vector<LaneId> queued_;  ///< lanes with a queue at this look
  int looks_ = 0;
  Millis last_lesson_ = -1;
};

}  // namespace thalweg
