// SPDX-License-Identifier: Apache-2.0
#include "traffic/queue_forecast.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace thalweg {
namespace {

constexpr float still_there = std::numeric_limits<float>::infinity();

}  // namespace

QueueForecast::QueueForecast(const Network& network, const Servers& servers, const Discharge& discharge,
                             const ForecastOptions& options)
    : network_(network),
      servers_(servers),
      discharge_(discharge),
      options_(options),
      departures_(options.repeated),
      horizon_(to_seconds(options.bin) * static_cast<double>(options.bins)),
      calendar_(horizon_),
      queues_(network.lanes.size()),
      passed_(network.lanes.size()),
      rooms_(network.roads.size()),
      delayed_(network.roads.size()),
      lines_(network.lanes.size()),
      table_(network, options.bin, options.bins, options.tolls) {}

void QueueForecast::run(const Fleet& fleet, const Level& level, Millis now) {
  junction_pace_ = level.junction_pace();
  for (const LaneId lane : used_) {
    queues_[lane] = {};
    passed_[lane].clear();
  }
  used_.clear();
  movers_.clear();
  calendar_.clear();
  for (std::size_t i = 0; i < rooms_.size(); ++i) {
    const RoadId road{i};
    Room& room = rooms_[road];
    room.storage = servers_.storage(road);
    room.crossing = level.pace() * servers_.free_flow(road);
    room.occupancy = 0;
    room.held_up.clear();
  }
  for (auto& times : delayed_) times.clear();
  for (const LaneId line : lined_) lines_[line].clear();
  lined_.clear();
  insertion_.assign(fleet.size(), 0);
  leaving_.assign(fleet.size(), {});
  for (const VehicleId vehicle : fleet.present()) place(vehicle, fleet[vehicle], now);
  for (std::size_t i = 0; i < rooms_.size(); ++i) {
    const Room& room = rooms_[RoadId{i}];
    table_.note_taken(RoadId{i}, room.occupancy / std::max(1.0, room.storage));
  }
  departures_.foresee(
      fleet, now, now + from_seconds(horizon_),
      [&](const std::vector<RoadId>& route, Millis time) { add_departure(route, to_seconds(time - now)); });
  calendar_.run([this](const auto& ahead) { prefetch(ahead); },
                [this](const Event& event) { handle(event); });
  let_in_after_horizon();
  table_.tabulate(servers_, discharge_, passed_, delayed_);
}

void QueueForecast::place(VehicleId id, const FleetVehicle& vehicle, Millis now) {
  if (vehicle.route.empty()) return;
  if (vehicle.state == FleetVehicle::State::waiting) {
    insertion_[id] = from_seconds(horizon_);  // unless its turn comes
    return add_departure(vehicle.route, to_seconds(vehicle.depart - now), id);
  }
  if (vehicle.is_lost || !vehicle.lane.valid()) return;
  std::size_t position = vehicle.position;
  double time = 0;
  LaneId preferred = vehicle.lane;
  if (vehicle.on_junction) {
    position = std::min(position + 1, vehicle.route.size() - 1);
    time = 1 + rooms_[vehicle.route[position]].crossing;
    preferred = {};
  } else {
    const double length = network_.lanes[vehicle.lane].length;
    const double left = length > 0 ? std::max(0.0, 1 - vehicle.metres / length) : 0;
    time = left * rooms_[vehicle.route[position]].crossing;
  }
  ++rooms_[vehicle.route[position]].occupancy;
  leaving_[id] = {.road = vehicle.route[position], .time = from_seconds(horizon_)};
  Mover mover = on(vehicle.route, position);
  mover.preferred = preferred;
  mover.vehicle = id;
  add(mover, time, Kind::reaches_end);
}

void QueueForecast::add_departure(const std::vector<RoadId>& route, double wanted, VehicleId vehicle) {
  Mover mover = on(route);
  mover.vehicle = vehicle;
  mover.wanted = static_cast<float>(wanted);
  add(mover, std::max(0.0, wanted), Kind::departs);
}

void QueueForecast::add(const Mover& mover, double time, Kind kind) {
  if (time > horizon_) return;
  movers_.push_back(mover);
  push(time, kind, static_cast<std::uint32_t>(movers_.size() - 1));
}

void QueueForecast::prefetch(const EventCalendar<Event>::Foreseen& ahead) {
  for (std::size_t i = 0; i < ahead.size() && ahead[i] != nullptr; ++i) {
    if (ahead[i]->kind == Kind::reaches_end) prefetch_reaching(ahead[i]->subject, i + 1);
    if (ahead[i]->kind == Kind::leaves) prefetch_leaving(LaneId{ahead[i]->subject}, i + 1);
  }
}

void QueueForecast::prefetch_reaching(std::uint32_t id, std::size_t events_ahead) {
  Mover& mover = movers_[id];
  switch (events_ahead) {
    case 4:
      return __builtin_prefetch(&mover);
    case 3:
      return __builtin_prefetch(mover.road);
    case 2:
      mover.movement = movement_of(mover);
      if (!mover.movement.valid()) return;
      __builtin_prefetch(&servers_[mover.movement]);
      for (const LaneId lane : servers_.lanes(mover.movement)) prefetch_queue(lane);
      return;
    default:
      if (!mover.movement.valid()) return;
      for (const LaneId lane : servers_.lanes(mover.movement)) {
        const std::vector<Passed>& passed = passed_[lane];
        __builtin_prefetch(passed.data() + passed.size(), 1);
      }
  }
}

void QueueForecast::prefetch_leaving(LaneId lane, std::size_t events_ahead) const {
  switch (events_ahead) {
    case 4:
      prefetch_queue(lane);
      return discharge_.prefetch(lane);
    case 3:
      return __builtin_prefetch(&first_in(lane));
    case 2:
      __builtin_prefetch(&movers_[first_in(lane).mover]);
      return __builtin_prefetch(&servers_[first_in(lane).movement]);
    default:
      return __builtin_prefetch(&rooms_[servers_[first_in(lane).movement].to]);
  }
}

void QueueForecast::prefetch_queue(LaneId lane) const {
  __builtin_prefetch(&queues_[lane]);
  __builtin_prefetch(&passed_[lane]);
}

void QueueForecast::handle(const Event& event) {
  switch (event.kind) {
    case Kind::departs:
      return depart(event);
    case Kind::enters:
      return enter(event);
    case Kind::reaches_end:
      return reach_end(event);
    case Kind::leaves:
      return leave(LaneId{event.subject}, event.time);
    case Kind::forces_its_way:
      return force_its_way(event);
  }
}

void QueueForecast::depart(const Event& event) {
  const Mover& mover = movers_[event.subject];
  const LaneId id =
      discharge_.insertions().line(*mover.road, mover.road == mover.last ? RoadId{} : mover.road[1]);
  WaitingLine& line = lines_[id];
  if (line.vehicles().empty()) lined_.push_back(id);
  line.join(event.subject, mover.wanted);
  if (line.waiting().size() == 1) push(std::max(event.time, line.free_at()), Kind::enters, id.value);
}

void QueueForecast::enter(const Event& event) {
  const LaneId id{event.subject};
  WaitingLine& line = lines_[id];
  const std::uint32_t first = line.waiting().front().mover;
  Mover& mover = movers_[first];
  const RoadId road = *mover.road;
  Room& room = rooms_[road];
  if (room.occupancy >= room.storage * options_.full)
    return push(event.time + options_.insertion_retry, Kind::enters, id.value);
  ++room.occupancy;
  line.let_in_first(event.time, discharge_.insertions().headway(id));
  if (mover.vehicle.valid()) insertion_[mover.vehicle] = from_seconds(event.time);
  mover.vehicle = {};
  push(event.time + room.crossing, Kind::reaches_end, first);
  if (!line.waiting().empty()) push(line.free_at(), Kind::enters, id.value);
}

void QueueForecast::let_in_after_horizon() {
  for (const LaneId id : lined_) {
    WaitingLine& line = lines_[id];
    while (!line.waiting().empty()) {
      const VehicleId vehicle = movers_[line.waiting().front().mover].vehicle;
      const double time = std::max(horizon_, line.free_at());
      line.let_in_first(time, discharge_.insertions().headway(id));
      if (vehicle.valid()) insertion_[vehicle] = from_seconds(time);
    }
  }
}

Millis QueueForecast::insertion(LaneId line, Millis wanted) const {
  return from_seconds(lines_[line].when(to_seconds(wanted), discharge_.insertions().headway(line)));
}

void QueueForecast::reach_end(const Event& event) {
  Mover& mover = movers_[event.subject];
  const RoadId road = *mover.road;
  const MovementId movement = mover.movement.valid() ? mover.movement : movement_of(mover);
  if (!movement.valid()) {
    if (mover.vehicle.valid()) leaving_[mover.vehicle].time = from_seconds(event.time);
    return give_up_place(road, event.time);
  }
  const auto lanes = servers_.lanes(movement);
  LaneId shortest = lanes.front();
  const auto length = [&](LaneId lane) { return passed_[lane].size() - queues_[lane].head; };
  for (const LaneId lane : lanes) {
    if (length(lane) < length(shortest)) shortest = lane;
  }
  for (const LaneId lane : lanes) {
    if (lane == mover.preferred) shortest = lane;  // where it is already
  }
  mover.preferred = {};
  std::vector<Passed>& passed = passed_[shortest];
  if (passed.empty()) used_.push_back(shortest);
  passed.push_back({.arrived = static_cast<float>(event.time),
                    .left = still_there,
                    .mover = event.subject,
                    .movement = movement});
  if (!queues_[shortest].is_active) schedule_head(shortest);
}

void QueueForecast::schedule_head(LaneId lane) {
  Queue& queue = queues_[lane];
  const Passed& first = first_in(lane);
  const double ready = first.arrived + servers_[first.movement].delay;
  const double time = std::max(ready, queue.free_at);
  queue.is_active = true;
  if (calendar_.is_now(time))
    leave(lane, time);
  else
    push(time, Kind::leaves, lane.value);
}

void QueueForecast::leave(LaneId lane, double time) {
  Queue& queue = queues_[lane];
  Passed& passed = passed_[lane][queue.head];
  Mover& mover = movers_[passed.mover];
  const Movement& movement = servers_[passed.movement];
  const RoadId next = movement.to;
  Room& room = rooms_[next];
  if (room.is_full() && !is_out_of_patience(queue, time)) {  // the queue ahead has come back to here
    if (queue.blocked_since < 0) {
      queue.blocked_since = time;
      push(time + options_.blocked_patience, Kind::forces_its_way, lane.value);
    }
    room.held_up.push_back(lane);
    queue.held_by = next;
    queue.held_at = time;
    return;
  }
  if (queue.held_by.valid() && queue.held_by != next && passed.arrived <= queue.held_at)
    delayed_[queue.held_by].push_back(static_cast<float>(time));  // had no wish to get on that road
  queue.blocked_since = -1;
  if (mover.vehicle.valid()) leaving_[mover.vehicle].time = from_seconds(time);
  mover.vehicle = {};
  passed.left = static_cast<float>(time);
  ++queue.head;
  queue.is_active = false;
  queue.free_at = time + movement.headway * discharge_.factor(lane);
  ++room.occupancy;
  ++mover.road;
  mover.movement = {};
  push(time + junction_pace_ * movement.through + room.crossing, Kind::reaches_end, passed.mover);
  if (queue.head < passed_[lane].size()) schedule_head(lane);
  give_up_place(movement.from, time);
}

void QueueForecast::force_its_way(const Event& event) {
  const LaneId lane{event.subject};
  if (!is_out_of_patience(queues_[lane], event.time)) return;  // another waits there now
  if (std::erase(rooms_[servers_[first_in(lane).movement].to].held_up, lane) > 0) leave(lane, event.time);
}

void QueueForecast::give_up_place(RoadId road, double time) {
  Room& room = rooms_[road];
  --room.occupancy;
  std::vector<LaneId>& lanes = room.held_up;
  if (lanes.empty() || room.is_full()) return;
  // Else those who want to get on a roundabout would fill it, and nobody could leave it any more.
  const auto rank = [&](LaneId lane) {
    return std::tuple(servers_[first_in(lane).movement].gives_way, queues_[lane].blocked_since, lane);
  };
  const auto first =
      std::min_element(lanes.begin(), lanes.end(), [&](LaneId a, LaneId b) { return rank(a) < rank(b); });
  push(time + options_.gap_travel, Kind::leaves, first->value);
  lanes.erase(first);
}

}  // namespace thalweg
