// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/id.hpp"
#include "core/time.hpp"
#include "network/vehicle_class.hpp"

namespace thalweg {

/// Metres in the net's own coordinates.
struct Point {
  double x = 0;
  double y = 0;
  double z = 0;
};
using Shape = std::vector<Point>;

/// `zone`: a road of no length that stands for where a zone's trips begin or end (network/zones.hpp).
enum class RoadFunction : std::uint8_t { normal, connector, internal, crossing, walking_area, zone };

struct Lane {
  RoadId road;
  double length = 0;  ///< m
  double speed = 0;   ///< m/s, the limit
  Permissions permissions = Permissions::all();
  Permissions change_left = Permissions::all();
  Permissions change_right = Permissions::all();
  Shape shape;
};

/// Lanes that are numbered one after the other.
class LaneRange {
 public:
  struct Iterator {
    LaneId lane;
    LaneId operator*() const { return lane; }
    Iterator& operator++() {
      ++lane.value;
      return *this;
    }
    bool operator==(const Iterator&) const = default;
  };
  LaneRange(LaneId first, LaneId end) : first_{first}, end_{end} {}
  [[nodiscard]] Iterator begin() const { return first_; }
  [[nodiscard]] Iterator end() const { return end_; }

 private:
  Iterator first_;
  Iterator end_;
};

/// An edge of the net. Lanes are numbered from the kerb, and stand one after the other in Network::lanes.
struct Road {
  std::string id;
  RoadFunction function = RoadFunction::normal;
  JunctionId from;  ///< invalid on internal roads
  JunctionId to;
  std::string type;
  std::string name;
  int priority = 0;
  LaneId first_lane;
  std::uint32_t lane_count = 0;
  Shape shape;  ///< empty when the net leaves it to the junctions and lanes

  /// Counted from the kerb; less than lane_count.
  [[nodiscard]] LaneId lane(std::uint32_t index) const { return LaneId{first_lane.value + index}; }
  /// From the kerb.
  [[nodiscard]] LaneRange lanes() const { return {first_lane, lane(lane_count)}; }
};

/// A lane-to-lane connection, as `state` and `dir` of the net say ('M', 'm', 's', 'o' ..; 's', 'l', 'r', 't'
/// ..).
struct Connection {
  RoadId from;
  RoadId to;
  std::uint32_t from_lane = 0;
  std::uint32_t to_lane = 0;
  LaneId via{};  ///< the internal lane that leads on; invalid where the net has none
  char direction = 's';
  char state = 'M';
  SignalId signal{};
  int link_index = -1;
  Permissions permissions = Permissions::all();
};
/// It leads back into the reverse of its road.
inline bool is_turnaround(const Connection& connection) {
  return connection.direction == 't' || connection.direction == 'T';
}

struct Junction {
  std::string id;
  std::string type;
  Point position;
  Shape shape;
};

struct SignalPhase {
  Millis duration = 0;
  std::string state;  ///< one letter a link index
};
struct SignalProgramme {
  std::string id;
  std::string type;  ///< static, actuated, delay_based ..
  Millis offset = 0;
  std::vector<SignalPhase> phases;
  /// When a cycle began, of one that runs and whose phases have fixed lengths; else nothing.
  std::optional<Millis> cycle_start{};
  bool follows_traffic = false;  ///< one that runs and whose phases last as long as somebody comes
};
/// Which phase of its programme a signal shows, and since when.
struct ShownPhase {
  std::size_t index = 0;
  Millis since = 0;
};
struct Signal {
  std::string id;
  std::vector<SignalProgramme> programmes;
};

struct Roundabout {
  std::vector<JunctionId> junctions;
  std::vector<RoadId> roads;
};

struct Location {
  Point net_offset;
  std::string projection;  ///< PROJ string; "!" when there is none
  std::string converted_boundary;
  std::string original_boundary;
};

/// A limit that a road type sets for one class (`<type><restriction vClass speed/>`).
struct SpeedRestriction {
  std::string type;
  VehicleClass vehicle_class;
  double speed;  ///< m/s
};

/// What the .net.xml says, nothing derived.
struct Network {
  IdVector<RoadId, Road> roads;
  IdVector<LaneId, Lane> lanes;
  IdVector<JunctionId, Junction> junctions;
  IdVector<ConnectionId, Connection> connections;
  IdVector<SignalId, Signal> signals;
  std::vector<Roundabout> roundabouts;
  std::vector<SpeedRestriction> restrictions;
  Location location;
  bool left_hand = false;
  std::vector<std::string> warnings;  ///< what was odd and read on from

  [[nodiscard]] std::optional<RoadId> find_road(std::string_view id) const;

  struct StringHash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>{}(text); }
  };
  template <class T>
  using Names = std::unordered_map<std::string, T, StringHash, std::equal_to<>>;
  Names<RoadId> road_ids;
};

}  // namespace thalweg
