// SPDX-License-Identifier: Apache-2.0
#include "report/gap.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/number.hpp"
#include "search/dijkstra.hpp"
#include "search/timed_search.hpp"
#include "traffic/recorded_times.hpp"
#include "xml/reader.hpp"

namespace thalweg {
namespace {

struct DrivenTrip {
  VehicleId vehicle;
  Millis depart = 0;
  std::vector<RoadId> route;
};

/// The trips that finished, with the routes they had at last.
class RouteHandler : public xml::Handler {
 public:
  RouteHandler(const Network& network, const Demand& demand) : network_(network), demand_(demand) {
    for (std::size_t i = 0; i < demand.vehicles.size(); ++i)
      ids_.emplace(demand.vehicles[VehicleId{i}].id, VehicleId{i});
  }

  void start(const xml::Element& element) override {
    if (element.name() == "vehicle") {
      const auto found = ids_.find(element.require("id"));
      is_wanted_ = found != ids_.end() && !demand_.vehicles[found->second].fixed && element.find("arrival");
      if (is_wanted_) trip_ = {.vehicle = found->second, .depart = element.time("depart"), .route = {}};
    } else if (element.name() == "stop") {
      is_wanted_ = false;
    } else if (element.name() == "route" && is_wanted_) {
      trip_.route.clear();  // the last of several is the one that was driven
      for (const auto edge : split(element.require("edges"), " ")) {
        const auto road = network_.find_road(edge);
        if (road && network_.roads[*road].function == RoadFunction::normal) trip_.route.push_back(*road);
      }
    }
  }
  void end(std::string_view name) override {
    if (name == "vehicle" && is_wanted_ && !trip_.route.empty()) trips.push_back(std::move(trip_));
    if (name == "vehicle") is_wanted_ = false;
  }

  std::vector<DrivenTrip> trips;

 private:
  const Network& network_;
  const Demand& demand_;
  std::unordered_map<std::string_view, VehicleId> ids_;
  DrivenTrip trip_;
  bool is_wanted_ = false;
};

/// The roads as one class finds them: its searches.
class ClassRoads {
 public:
  ClassRoads(const Network& network, VehicleClass vehicle_class, const RecordedTimes& times)
      : graph_(network, vehicle_class),
        free_flow_(free_flow_times(network, vehicle_class, default_max_speed(vehicle_class), {})),
        times_(times) {
    RoadTimes least = free_flow_;
    for (std::size_t i = 0; i < least.size(); ++i)
      least[RoadId{i}] = times.least(RoadId{i}, least[RoadId{i}]);
    turn_costs(graph_, least, least_);
  }

  /// When a vehicle that enters the tail of `turn` enters its head.
  [[nodiscard]] Millis arrive(ArcId turn, Millis time) const {
    time = cross(graph_.road(graph_.turns().ends(turn).tail), time);
    for (const RoadId road : graph_.junction_roads(turn)) time = cross(road, time);
    return time;
  }

  /// From entering the first road to entering the last; nullopt: two of its roads are not joined.
  [[nodiscard]] std::optional<Millis> drive(const std::vector<RoadId>& route, Millis time) const {
    for (std::size_t i = 0; i + 1 < route.size(); ++i) {
      Millis next = infinity;
      for (const Arc& turn : graph_.turns().out(graph_.vertex(route[i]))) {
        if (turn.end == graph_.vertex(route[i + 1])) next = std::min(next, arrive(turn.id, time));
      }
      if (next >= infinity) return std::nullopt;
      time = next;
    }
    return time;
  }

  /// The earliest arrival at the last of `waypoints` by way of the others; not after `bound`, which is one
  /// that is possible.
  Millis fastest(RoadId from, const std::vector<RoadId>& waypoints, Millis time, Millis bound) {
    VertexId at = graph_.vertex(from);
    for (const RoadId waypoint : waypoints) {
      const VertexId to = graph_.vertex(waypoint);
      const auto& left = potential(to);
      const auto found = timed_search(
          graph_.turns(), at, time, 0, to, {.latest = bound},
          [&](ArcId turn, Millis entry) { return arrive(turn, entry); }, no_toll,
          [&](VertexId v, Millis, Millis) { return left[v]; }, scratch_);
      if (!found) return bound;
      time = found->arrival;
      at = to;
    }
    return std::min(time, bound);
  }

  [[nodiscard]] Millis cross(RoadId road, Millis time) const {
    return times_.leave(road, time, free_flow_[road]);
  }

 private:
  /// The least time from everywhere; of the last destination asked for and of those of its `via`.
  const IdVector<VertexId, Millis>& potential(VertexId to) {
    if (potential_.size() > most_potentials && !potential_.contains(to)) potential_.clear();
    const auto [entry, is_new] = potential_.try_emplace(to);
    if (is_new) {
      dijkstra<Direction::backward>(
          graph_.turns(), std::span(&to, 1), [&](ArcId turn) { return least_[turn.value]; }, tree_,
          dijkstra_scratch_);
      entry->second = tree_.label;
    }
    return entry->second;
  }

  static constexpr std::size_t most_potentials = 16;  ///< trips come ordered by destination
  RoadGraph graph_;
  RoadTimes free_flow_;
  const RecordedTimes& times_;
  std::vector<Millis> least_;
  std::unordered_map<VertexId, IdVector<VertexId, Millis>> potential_;
  Tree tree_;
  DijkstraScratch dijkstra_scratch_;
  TimedScratch scratch_;
};

}  // namespace

RelativeGap relative_gap(const std::filesystem::path& routes, const std::filesystem::path& edge_data,
                         const Network& network, const Demand& demand) {
  const RecordedTimes times(edge_data, network);
  RouteHandler driven(network, demand);
  xml::read(routes, driven);
  std::stable_sort(driven.trips.begin(), driven.trips.end(),
                   [](const DrivenTrip& a, const DrivenTrip& b) { return a.route.back() < b.route.back(); });
  std::map<VehicleClass, std::unique_ptr<ClassRoads>> classes;
  RelativeGap gap;
  Millis own_sum = 0;
  Millis best_sum = 0;
  for (const DrivenTrip& trip : driven.trips) {
    const DemandVehicle& vehicle = demand.vehicles[trip.vehicle];
    auto& roads = classes[vehicle.vehicle_class];
    if (!roads) roads = std::make_unique<ClassRoads>(network, vehicle.vehicle_class, times);
    const auto own = roads->drive(trip.route, trip.depart);
    if (!own) continue;
    std::vector<RoadId> waypoints = vehicle.via;
    waypoints.push_back(trip.route.back());
    const Millis best = roads->fastest(trip.route.front(), waypoints, trip.depart, *own);
    const Millis own_time = roads->cross(trip.route.back(), *own) - trip.depart;
    const Millis best_time = std::min(own_time, roads->cross(trip.route.back(), best) - trip.depart);
    ++gap.trips;
    if (own_time * 20 > best_time * 21) ++gap.gaining;
    own_sum += own_time;
    best_sum += best_time;
  }
  gap.own_s = to_seconds(own_sum);
  gap.best_s = to_seconds(best_sum);
  return gap;
}

}  // namespace thalweg
