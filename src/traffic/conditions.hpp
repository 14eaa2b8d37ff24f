// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graph/road_graph.hpp"
#include "network/lane_changes.hpp"

namespace thalweg {

/// Which roads are closed or slow at this moment.
class Conditions {
 public:
  explicit Conditions(const Network& network, std::vector<LaneChange> changes = {});

  /// True when something is not as it was at the last call.
  bool advance(Millis now);
  /// How often something changed.
  [[nodiscard]] std::uint32_t version() const { return version_; }

  /// The roads that something ever happens to, in the order of the net.
  [[nodiscard]] std::span<const RoadId> roads() const { return roads_; }
  /// No lane may be used by this class now.
  [[nodiscard]] bool closed(RoadId road, VehicleClass vehicle_class) const;
  /// The turns that this graph's class may not take now, though the net permits them: into a closed road, or
  /// between lanes that are closed. Who is on a road that is wholly closed may leave it.
  [[nodiscard]] std::vector<ArcId> closed_turns(const RoadGraph& graph) const;
  /// Time to cross the road at its limit of now, in s; of its fastest lane.
  [[nodiscard]] double crossing(RoadId road) const;

 private:
  /// Whether this class may use the lane now.
  [[nodiscard]] bool open(LaneId lane, VehicleClass vehicle_class) const;

  const Network& network_;
  std::vector<LaneChange> changes_;
  std::vector<bool> active_;
  std::vector<RoadId> roads_;
  std::vector<ConnectionId> connections_;  ///< from or to these roads
  std::uint32_t version_ = 0;
};

}  // namespace thalweg
