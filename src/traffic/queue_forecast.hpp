// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "traffic/departures.hpp"
#include "traffic/discharge.hpp"
#include "traffic/event_calendar.hpp"
#include "traffic/fleet.hpp"
#include "traffic/level.hpp"
#include "traffic/queue_table.hpp"
#include "traffic/servers.hpp"
#include "traffic/waiting_line.hpp"

namespace thalweg {

struct ForecastOptions {
  Millis bin = 20'000;
  std::size_t bins = 60;          ///< the horizon is bins * bin
  Millis repeated = 600'000;      ///< departures of this past are repeated (Departures); 0: none assumed
  double full = 0.9;              ///< nobody is inserted on a road that is so full
  double gap_travel = 1.5;        ///< s until a place that became free is where the next one waits
  double blocked_patience = 150;  ///< s after which it goes anyway: the forecast must not lock up
  double insertion_retry = 5;     ///< s until the first in line looks again for room
  bool tolls = false;             ///< the table has them
};

/// Where the queues will be: everybody on the roads, waiting or loaded drives its present route from lane to
/// lane, each lane a FIFO server with room for so many, over the next minutes. Gives what one meets at the
/// end of each road, by the time of reaching the queue. Later departures that nobody knows yet are assumed to
/// be those of the last minutes again.
///
/// An event-based point-queue model with spillback (cf. Charypar, Axhausen, Nagel, Transportation Research
/// Record 2003, 2007).
class QueueForecast {
 public:
  QueueForecast(const Network& network, const Servers& servers, const Discharge& discharge,
                const ForecastOptions& options = {});

  /// Whom SUMO has not loaded yet.
  [[nodiscard]] Departures& departures() { return departures_; }
  /// Looks ahead from the fleet's present state; roads take their free flow times the level's pace.
  void run(const Fleet& fleet, const Level& level, Millis now);

  [[nodiscard]] const QueueTable& table() const { return table_; }
  /// When a vehicle that waited at the last run gets on its first road, from then on; 0 when it was not
  /// there. Beyond the horizon by its place in the line.
  [[nodiscard]] Millis insertion(VehicleId vehicle) const { return insertion_[vehicle]; }
  /// When one would that stood in this line, having wanted to depart at `wanted`, both from the last run on.
  [[nodiscard]] Millis insertion(LaneId line, Millis wanted) const;

  struct Leaving {
    RoadId road{};    ///< it was there at the last run, or about to enter; invalid: it was on none
    Millis time = 0;  ///< from the last run on; the horizon when later
  };
  /// When a vehicle that was on the roads leaves that one: by its own place in the queue, which the table
  /// does not know.
  [[nodiscard]] const Leaving& leaving(VehicleId vehicle) const { return leaving_[vehicle]; }

 private:
  /// A vehicle of the forecast: a real one, or one that is assumed.
  struct Mover {
    const RoadId* road;  ///< of its route
    const RoadId* last;  ///< the route's last road
    LaneId preferred{};
    MovementId movement{};  ///< the next one, where it was looked for already; else invalid
    VehicleId vehicle{};    ///< a real one, until it is inserted or leaves the road it was on
    float wanted = 0;       ///< s from now: its departure
  };
  static constexpr double long_ago = -1e9;  ///< s from now
  /// Of a lane; the vehicles in it and those that left it are its `passed_`.
  struct Queue {
    std::size_t head = 0;
    double free_at = long_ago;  ///< s from now: the server is done with the last
    double blocked_since = -1;  ///< s from now; below 0: it is not
    RoadId held_by{};           ///< the road that the last one who found no room wanted to get on
    double held_at = long_ago;  ///< s from now: when he looked for it
    bool is_active = false;
  };
  /// Of a road, what every vehicle that gets on it asks for, side by side.
  struct Room {
    double storage = 0;   ///< vehicles
    double crossing = 0;  ///< s, at the present pace
    int occupancy = 0;
    std::vector<LaneId> held_up{};  ///< lanes whose first waits for room here
    [[nodiscard]] bool is_full() const { return occupancy >= storage; }
  };
  enum class Kind : std::uint8_t { reaches_end, leaves, forces_its_way, departs, enters };
  struct Event {
    double time;            ///< s from now
    std::uint32_t subject;  ///< a mover; the lane for `leaves` and `forces_its_way`, the line for `enters`
    Kind kind;
  };

  /// Who drives the route, which outlives the run, from this road on.
  static Mover on(const std::vector<RoadId>& route, std::size_t position = 0) {
    return {.road = &route[position], .last = &route.back()};
  }
  void place(VehicleId id, const FleetVehicle& vehicle, Millis now);
  /// `wanted`: s from now, the past for one that waits already.
  void add_departure(const std::vector<RoadId>& route, double wanted, VehicleId vehicle = {});
  void add(const Mover& mover, double time, Kind kind);
  /// Has the memory fetch what the next events will need: vehicles that are there at the same time are
  /// nowhere near each other in it. What is needed to find the one thing is fetched an event before the
  /// other.
  void prefetch(const EventCalendar<Event>::Foreseen& ahead);
  void prefetch_reaching(std::uint32_t mover, std::size_t events_ahead);
  void prefetch_leaving(LaneId lane, std::size_t events_ahead) const;
  void prefetch_queue(LaneId lane) const;
  void handle(const Event& event);
  void depart(const Event& event);
  void enter(const Event& event);
  /// Each by its place in the line.
  void let_in_after_horizon();
  void reach_end(const Event& event);
  void leave(LaneId lane, double time);
  void force_its_way(const Event& event);
  /// Invalid: it arrives, or its route is not what SUMO drives.
  [[nodiscard]] MovementId movement_of(const Mover& mover) const {
    return mover.road == mover.last ? MovementId{} : servers_.find(*mover.road, mover.road[1]);
  }
  [[nodiscard]] const Passed& first_in(LaneId lane) const { return passed_[lane][queues_[lane].head]; }
  [[nodiscard]] bool is_out_of_patience(const Queue& queue, double time) const {
    return queue.blocked_since >= 0 && time >= queue.blocked_since + options_.blocked_patience;
  }
  /// One has left the road: somebody may follow, when the gap has moved back to him (a jam spreads at some
  /// 5 m/s, 7.5 m a vehicle).
  void give_up_place(RoadId road, double time);
  /// The first in the lane leaves in this tick, without an event (more than half of all do), or later.
  void schedule_head(LaneId lane);
  void push(double time, Kind kind, std::uint32_t subject) {
    calendar_.add({.time = time, .subject = subject, .kind = kind});
  }

  const Network& network_;
  const Servers& servers_;
  const Discharge& discharge_;
  ForecastOptions options_;
  Departures departures_;
  double horizon_;
  double junction_pace_ = 1;

  std::vector<Mover> movers_;
  EventCalendar<Event> calendar_;
  IdVector<LaneId, Queue> queues_;
  IdVector<LaneId, std::vector<Passed>> passed_;
  std::vector<LaneId> used_;  ///< queues that the next run has to clear
  IdVector<RoadId, Room> rooms_;
  IdVector<RoadId, std::vector<float>> delayed_;  ///< s from now: when others who waited behind these went on
  IdVector<LaneId, WaitingLine> lines_;
  std::vector<LaneId> lined_;  ///< lines that the next run has to clear
  IdVector<VehicleId, Millis> insertion_;
  IdVector<VehicleId, Leaving> leaving_;
  QueueTable table_;
};

}  // namespace thalweg
