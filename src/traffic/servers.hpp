// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "network/network.hpp"
#include "traffic/signal_waits.hpp"

namespace thalweg {

/// From a road onto the next, by whatever lanes.
struct Movement {
  RoadId from;
  RoadId to;
  double through = 0;      ///< s to cross the junction, nobody in the way
  double headway = 2;      ///< s between two vehicles that leave a lane one after the other
  double delay = 0;        ///< s that a vehicle waits at the stop line though nobody is before it
  bool gives_way = false;  ///< by the right of way; no signal says when
};

/// What those meet who reach the end of a road: nobody has to give way, some turns have to, all have to; a
/// signal.
enum class RoadEnd : std::uint8_t { major, mixed, minor, signal };
inline constexpr std::size_t road_end_count = 4;

struct ServerOptions {
  double saturation_headway = 2;  ///< s, of a lane that has green or the right of way
  double permissive = 0.5;        ///< worth of a green that has to give way, against a protected one
  double yellow = 0.3;            ///< of the yellow is driven
  double least_share = 0.03;      ///< a signal lets somebody pass in every cycle
  double space = 7.5;             ///< m of a lane that a waiting vehicle takes
  double least_storage = 2;       ///< vehicles: on the shortest road one arrives while one leaves
  bool signal_phases = true;      ///< it is known what signals show at which time (signal_waits)
};

/// Every lane as a server of those that leave it: how long one takes, and how many find room to wait.
/// Headways and delays from the signal programmes (green share of the link) and the right of way, in the mean
/// of a cycle; only on a road between two stop lines of one signal the phases count, since who was let in
/// there mostly finds the next one green. What signals show at which time is kept apart (signal_waits).
class Servers {
 public:
  explicit Servers(const Network& network, const ServerOptions& options = {});

  /// Takes the times of this signal from the programme that runs there now.
  void set_programme(SignalId signal, const SignalProgramme& programme);
  /// Its cycles begin at other times; the programme is the same.
  void set_cycle_start(SignalId signal, Millis start);
  /// Its limit is another now; in s. Delays between stop lines of one signal stay as they are.
  void set_free_flow(RoadId road, double seconds) { free_flow_[road] = seconds; }

  [[nodiscard]] std::size_t size() const { return movements_.size(); }
  [[nodiscard]] const Movement& operator[](MovementId movement) const { return movements_[movement]; }
  /// Invalid: no lane leads from one to the other.
  [[nodiscard]] MovementId find(RoadId from, RoadId to) const;
  /// The movements that leave a road; ids in a row.
  [[nodiscard]] std::size_t first_of(RoadId road) const { return first_[road.value]; }
  [[nodiscard]] std::size_t last_of(RoadId road) const { return first_[road.value + 1]; }
  [[nodiscard]] bool leads_on(RoadId road) const { return first_of(road) != last_of(road); }
  [[nodiscard]] std::span<const LaneId> lanes(MovementId movement) const {
    return {lanes_.data() + lane_first_[movement.value], lanes_.data() + lane_first_[movement.value + 1]};
  }
  /// Means over the movements that leave the lane; nothing when none does.
  struct LaneMeans {
    double headway = 0;
    double delay = 0;
  };
  [[nodiscard]] const LaneMeans& means(LaneId lane) const { return means_[lane]; }
  /// Whether the lane is one of those that the road's motor traffic queues on: open to cars where any is,
  /// else to buses or trams; footways and bicycle lanes only where there is nothing else.
  [[nodiscard]] bool carries(LaneId lane) const { return carries_[lane]; }
  /// Of the turns whose programme has a cycle that began at a time that is known, but for those between two
  /// stop lines of one signal.
  [[nodiscard]] const SignalWaits& signal_waits() const { return signal_waits_; }
  [[nodiscard]] double free_flow(RoadId road) const { return free_flow_[road]; }  ///< s
  [[nodiscard]] RoadEnd end(RoadId road) const { return ends_[road]; }
  /// Vehicles. Never fewer than are in service when its lanes let pass what they can, each of them for its
  /// mean delay (Little's law); else a road with room for three would let only three pass in a mean red.
  [[nodiscard]] double storage(RoadId road) const { return storage_[road]; }

 private:
  struct Link {
    MovementId movement;
    std::size_t index;
  };
  void measure_roads();
  void make_movements();
  void find_links();
  [[nodiscard]] std::vector<std::size_t> links_of(SignalId signal, MovementId movement) const;
  /// The delay at the end of a road that this signal alone lets vehicles onto; nothing for other roads.
  [[nodiscard]] std::optional<double> coordinated(SignalId signal, const SignalProgramme& programme,
                                                  MovementId movement) const;
  void find_feeding_signals();
  /// What follows from the movements that leave it: the means of its lanes, its room.
  void refresh_road(RoadId road);
  void find_ends();

  const Network& network_;
  ServerOptions options_;
  IdVector<MovementId, Movement> movements_;
  std::vector<RoadId> onto_;          ///< of each movement: side by side, since every forecast looks for many
  std::vector<std::uint32_t> first_;  ///< by road
  std::vector<std::uint32_t> lane_first_;
  std::vector<LaneId> lanes_;
  IdVector<LaneId, LaneMeans> means_;
  IdVector<LaneId, bool> carries_;
  IdVector<RoadId, RoadEnd> ends_;
  IdVector<RoadId, double> free_flow_;
  IdVector<RoadId, double> storage_;
  IdVector<RoadId, SignalId> fed_by_;  ///< the signal of all turns onto the road; invalid: none, or not all
  IdVector<SignalId, std::vector<Link>> links_;
  SignalWaits signal_waits_{0};
};

}  // namespace thalweg
