// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/time.hpp"
#include "graph/digraph.hpp"
#include "network/network.hpp"

namespace thalweg {

/// The net as one vehicle class may drive it: roads are vertices, turns are arcs. Every normal road (and
/// what stands for a zone) is a vertex, also one that the class may not use (it has no turns). A turn is an
/// arc for each different way through the junction, so there are parallel arcs where lanes lead to the same
/// road by different internal roads.
class RoadGraph {
 public:
  RoadGraph(const Network& network, VehicleClass vehicle_class);

  [[nodiscard]] VehicleClass vehicle_class() const { return vehicle_class_; }
  [[nodiscard]] const Digraph& turns() const { return turns_; }
  /// Invalid for an internal road, a crossing and the like.
  [[nodiscard]] VertexId vertex(RoadId road) const { return vertices_[road]; }
  [[nodiscard]] RoadId road(VertexId vertex) const { return roads_[vertex]; }
  /// The class may use a lane of this road.
  [[nodiscard]] bool permitted(VertexId vertex) const { return permitted_[vertex]; }
  /// The internal roads that the turn drives through, in order; empty in a net without them.
  [[nodiscard]] std::span<const RoadId> junction_roads(ArcId turn) const {
    return {junction_roads_.data() + junction_first_[turn.value],
            junction_roads_.data() + junction_first_[turn.value + 1]};
  }
  /// Into the reverse of its own road.
  [[nodiscard]] bool turns_back(ArcId turn) const { return turns_back_[turn.value]; }
  /// Pairs of roads that a turn joins (parallel arcs counted once).
  [[nodiscard]] std::size_t turn_count() const { return turn_count_; }

 private:
  VehicleClass vehicle_class_;
  Digraph turns_;
  IdVector<RoadId, VertexId> vertices_;
  IdVector<VertexId, RoadId> roads_;
  IdVector<VertexId, bool> permitted_;
  std::vector<std::uint32_t> junction_first_;
  std::vector<RoadId> junction_roads_;
  std::vector<bool> turns_back_;
  std::size_t turn_count_ = 0;
};

/// The time to cross each road, internal ones included.
using RoadTimes = IdVector<RoadId, Millis>;

/// What a turn costs beside its length, as SUMO's routers have it (`--weights.minor-penalty` ..).
struct TurnPenalties {
  Millis minor = 1'500;       ///< a turn that must give way
  Millis turnaround = 5'000;  ///< a turn back into the road's own reverse
  Millis signal = 0;          ///< a turn controlled by a traffic light
};

/// Free-flow times of a class: length / min(limit, max_speed [m/s]) of the fastest lane, and on internal
/// roads the penalty of the turn that enters them. A road with limit 0 takes for ever.
RoadTimes free_flow_times(const Network& network, VehicleClass vehicle_class, double max_speed,
                          const TurnPenalties& penalties);

/// Cost of each turn: the road that is left and the junction. The last road of a route is not in it.
void turn_costs(const RoadGraph& graph, const RoadTimes& times, std::vector<Millis>& costs);

}  // namespace thalweg
