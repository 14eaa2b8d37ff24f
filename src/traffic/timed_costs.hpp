// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "graph/road_graph.hpp"
#include "traffic/bookings.hpp"
#include "traffic/conditions.hpp"
#include "traffic/level.hpp"
#include "traffic/residuals.hpp"
#include "traffic/servers.hpp"

namespace thalweg {

/// What the costs are made of.
struct Expectation {
  const QueueTable& forecast;
  const Bookings& bookings;
  const Servers& servers;
  const Level& level;
  const Residuals& residuals;
  const Conditions& conditions;

  /// Above free flow, in s, of one that enters the road `ahead` s after the forecast and drives on at its
  /// end.
  [[nodiscard]] double delay(RoadId road, double ahead) const {
    return level.extra(servers, road) + residuals.lasting(road) +
           residuals.passing(road) * residuals.passing_left(ahead) +
           residuals.late(road) * residuals.late_share(ahead) +
           forecast.wait_after(road, ahead + servers.free_flow(road));
  }
};

/// The time of every turn by the time of entering the road that is left, as one class will find it: the
/// paper's f(t, I) over the horizon of a forecast. Piecewise linear, and made so that leaving later never
/// arrives earlier; before now it is that of now, after the horizon that of its end. On top, where
/// SignalWaits knows the signal: what it shows at that time, the less the longer the queue; and for a turn
/// back onto a road that is crowded now, what makes that a last resort.
class TimedCosts {
 public:
  TimedCosts(const Network& network, const RoadGraph& graph);

  /// What a turn costs that is closed.
  static constexpr Millis closed = 100'000'000;

  /// From a forecast made at `now`.
  void refresh(const Expectation& expected, Millis now);
  /// One road again, after bookings on it.
  void refresh(const Expectation& expected, RoadId road);

  [[nodiscard]] Millis arrive(ArcId turn, Millis entry) const {
    // Divisions of 32 bits are a fraction of those of 64.
    const auto since = static_cast<std::uint32_t>(std::clamp<Millis>(entry - now_, 0, horizon_));
    const std::uint32_t bin = since / static_cast<std::uint32_t>(bin_);
    const Millis within = since - static_cast<Millis>(bin) * bin_;
    const std::int32_t* cost = costs_.data() + turn.value * nodes_ + bin;
    const Millis at = cost[0];
    const Millis out = entry + (within == 0 ? at : at + (cost[1] - at) * within / bin_);
    return after_line_[turn.value] >= 0 ? in_phase(turn, entry, out) : out;
  }
  /// Nobody in the way: never above what `arrive` takes. By turn.
  [[nodiscard]] const std::vector<Millis>& free_flow() const { return free_flow_; }
  /// What each takes at the best time there is; infinity when it is closed. Bookings since the last refresh
  /// as a whole do not count.
  [[nodiscard]] const std::vector<Millis>& least() const { return least_; }
  /// The same of those who come when nobody knows any more what signals will show (SignalWaits::known_ahead).
  [[nodiscard]] const std::vector<Millis>& least_in_mean() const { return least_in_mean_; }
  /// From entering the road at the forecast's moment to its end; the turns there come on top.
  [[nodiscard]] Millis to_end(VertexId road) const { return to_end_[road.value]; }
  /// To cross the road itself, as its limit is in the net.
  [[nodiscard]] Millis road_time(RoadId road) const { return road_times_[road]; }
  /// The same as its limit is now.
  [[nodiscard]] Millis crossing(RoadId road) const {
    return road_times_[road] + from_seconds(slower_[road.value]);
  }

 private:
  void take_signals(const Expectation& expected);
  /// When one that entered the road at `entry` has made the turn, who would have at `out` in the mean of a
  /// cycle.
  [[nodiscard]] Millis in_phase(ArcId turn, Millis entry, Millis out) const;
  void refresh_vertex(const Expectation& expected, VertexId v);
  /// `lasting`, `passing`: s within the junction.
  void refresh_turn(ArcId turn, double lasting, double passing);
  void take_conditions(const Conditions& conditions);

  /// Who turns back onto a road without room waits for it within the junction, in the way of all behind him,
  /// and where another one does so at the road's other end neither of them ever moves again.
  static constexpr double crowded = 0.5;      ///< share of a road's room that is taken
  static constexpr double turned_back = 120;  ///< s

  const RoadGraph& graph_;
  RoadTimes road_times_;
  std::vector<Millis> free_flow_;
  Millis now_ = 0;
  Millis bin_ = 1;
  Millis horizon_ = 0;
  std::size_t nodes_ = 1;
  std::vector<Millis> least_;          ///< by turn
  std::vector<Millis> least_in_mean_;  ///< by turn
  std::vector<std::int32_t> costs_;    ///< ms, by turn and bin
  std::vector<Millis> to_end_;         ///< by road
  std::vector<double> fading_;         ///< share of passing residuals that is left, by bin
  std::vector<double> late_;           ///< share of the late ones that counts yet, by bin
  std::vector<double> slower_;         ///< s above free flow, by road
  std::vector<bool> is_closed_;        ///< by turn
  const QueueTable* forecast_ = nullptr;
  const SignalWaits* signal_waits_ = nullptr;
  std::vector<MovementId> movements_;  ///< by turn
  /// By turn: from coming to the stop line, nobody before it, to the end of the turn, in the mean; below 0
  /// where nobody knows what the signal will show, or there is none.
  std::vector<Millis> after_line_;
  std::vector<double> delay_;  ///< scratch: s at one road, by bin
};

}  // namespace thalweg
