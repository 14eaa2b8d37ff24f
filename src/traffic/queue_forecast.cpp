// SPDX-License-Identifier: Apache-2.0
#include "traffic/queue_forecast.hpp"

#include <algorithm>
#include <limits>

namespace thalweg {
namespace {

constexpr float still_there = std::numeric_limits<float>::infinity();

}  // namespace

void QueueForecast::Queue::clear() {
  movers.clear();
  passed.clear();
  head = 0;
  free_at = -1e9;
  blocked_since = -1;
  is_active = false;
}

QueueForecast::QueueForecast(const Network& network, const Servers& servers, const Discharge& discharge,
                             const ForecastOptions& options)
    : network_(network),
      servers_(servers),
      discharge_(discharge),
      options_(options),
      horizon_(to_seconds(options.bin) * static_cast<double>(options.bins)),
      seconds_(static_cast<std::size_t>(horizon_) + 1),
      queues_(network.lanes.size()),
      occupancy_(network.roads.size()),
      next_insertion_(network.roads.size()),
      wait_(network.roads.size() * options.bins, 0.0F) {}

void QueueForecast::observe(const Fleet& fleet, Millis now) {
  for (const VehicleId vehicle : fleet.present()) {
    const FleetVehicle& own = fleet[vehicle];
    if (own.depart <= noted_until_ || own.depart > now || own.route.size() < 2) continue;
    recent_.push_back({.time = own.depart, .route = own.route});
  }
  noted_until_ = now;
  while (!recent_.empty() && recent_.front().time < now - 2 * options_.repeated) recent_.pop_front();
}

void QueueForecast::run(const Fleet& fleet, Millis now) {
  for (const LaneId lane : used_) queues_[lane].clear();
  used_.clear();
  movers_.clear();
  for (auto& events : seconds_) events.clear();
  second_ = 0;
  occupancy_.assign(occupancy_.size(), 0);
  next_insertion_.assign(next_insertion_.size(), -1e9);
  for (const VehicleId vehicle : fleet.present()) place(fleet[vehicle], to_seconds(now));
  assume_departures(fleet, now);
  // A heap a second and not one for all: most events are far off, and need no order among themselves yet.
  for (second_ = 0; second_ < seconds_.size(); ++second_) {
    auto& events = seconds_[second_];
    std::make_heap(events.begin(), events.end());
    while (!events.empty()) {
      std::pop_heap(events.begin(), events.end());
      const Event event = events.back();
      events.pop_back();
      handle(event);
    }
  }
  tabulate();
}

void QueueForecast::place(const FleetVehicle& vehicle, double now) {
  if (vehicle.route.empty()) return;
  if (vehicle.state == FleetVehicle::State::waiting) {
    add(vehicle.route, 0, std::max(0.0, to_seconds(vehicle.depart) - now), Kind::departs, {});
    return;
  }
  if (vehicle.is_lost || !vehicle.lane.valid()) return;
  std::size_t position = vehicle.position;
  double time = 0;
  LaneId preferred = vehicle.lane;
  if (vehicle.on_junction) {
    position = std::min(position + 1, vehicle.route.size() - 1);
    time = 1 + servers_.free_flow(vehicle.route[position]);
    preferred = {};
  } else {
    const double length = network_.lanes[vehicle.lane].length;
    const double left = length > 0 ? std::max(0.0, 1 - vehicle.metres / length) : 0;
    time = left * servers_.free_flow(vehicle.route[position]);
  }
  ++occupancy_[vehicle.route[position]];
  add(vehicle.route, position, time, Kind::reaches_end, preferred);
}

void QueueForecast::assume_departures(const Fleet& fleet, Millis now) {
  Millis known_until = now;  // SUMO has loaded everybody up to here
  for (const VehicleId vehicle : fleet.present()) known_until = std::max(known_until, fleet[vehicle].depart);
  if (expected_.empty()) {
    if (options_.repeated > 0) repeat_departures(known_until, now);
    return;
  }
  auto next = std::upper_bound(expected_.begin(), expected_.end(), known_until,
                               [](Millis time, const Departure& departure) { return time < departure.time; });
  for (; next != expected_.end() && to_seconds(next->time - now) <= horizon_; ++next)
    add(next->route, 0, to_seconds(next->time - now), Kind::departs, {});
}

void QueueForecast::repeat_departures(Millis known_until, Millis now) {
  for (const Departure& departure : recent_) {
    if (departure.time <= known_until - options_.repeated || departure.time > known_until) continue;
    for (Millis time = departure.time + options_.repeated; to_seconds(time - now) <= horizon_;
         time += options_.repeated) {
      if (time > known_until) add(departure.route, 0, to_seconds(time - now), Kind::departs, {});
    }
  }
}

void QueueForecast::add(const std::vector<RoadId>& route, std::size_t position, double time, Kind kind,
                        LaneId preferred) {
  if (time > horizon_) return;
  movers_.push_back({.route = &route, .position = position, .preferred = preferred});
  push(time, kind, static_cast<std::uint32_t>(movers_.size() - 1));
}

void QueueForecast::push(double time, Kind kind, std::uint32_t subject) {
  if (time > horizon_) return;
  const std::size_t second = std::max(second_, static_cast<std::size_t>(std::max(0.0, time)));
  auto& events = seconds_[second];
  events.push_back({.time = time, .kind = kind, .subject = subject});
  if (second == second_) std::push_heap(events.begin(), events.end());
}

void QueueForecast::handle(const Event& event) {
  switch (event.kind) {
    case Kind::departs:
      return depart(event);
    case Kind::reaches_end:
      return reach_end(event);
    case Kind::leaves:
      return leave(event);
  }
}

void QueueForecast::depart(const Event& event) {
  Mover& mover = movers_[event.subject];
  const RoadId road = mover.route->front();
  if (occupancy_[road] >= servers_.storage(road) * options_.full)
    return push(event.time + options_.insertion_retry, Kind::departs, event.subject);
  if (!mover.booked) {
    mover.booked = true;
    const double turn = next_insertion_[road];
    next_insertion_[road] = std::max(turn, event.time) + discharge_.insertion_headway(road);
    if (event.time < turn) return push(turn, Kind::departs, event.subject);
  }
  ++occupancy_[road];
  push(event.time + servers_.free_flow(road), Kind::reaches_end, event.subject);
}

void QueueForecast::reach_end(const Event& event) {
  Mover& mover = movers_[event.subject];
  const RoadId road = (*mover.route)[mover.position];
  const bool is_last = mover.position + 1 >= mover.route->size();
  mover.movement = is_last ? MovementId{} : servers_.find(road, (*mover.route)[mover.position + 1]);
  if (!mover.movement.valid()) {  // arrived, or its route is not what SUMO drives
    --occupancy_[road];
    return;
  }
  const auto lanes = servers_.lanes(mover.movement);
  LaneId shortest = lanes.front();
  const auto length = [&](LaneId lane) { return queues_[lane].movers.size() - queues_[lane].head; };
  for (const LaneId lane : lanes) {
    if (length(lane) < length(shortest)) shortest = lane;
  }
  for (const LaneId lane : lanes) {
    if (lane == mover.preferred) shortest = lane;  // where it is already
  }
  mover.preferred = {};
  mover.arrived = static_cast<float>(event.time);
  Queue& queue = queues_[shortest];
  if (queue.movers.empty()) used_.push_back(shortest);
  queue.movers.push_back(event.subject);
  queue.passed.push_back({.arrived = mover.arrived, .left = still_there});
  if (!queue.is_active) schedule_head(shortest);
}

void QueueForecast::schedule_head(LaneId lane) {
  Queue& queue = queues_[lane];
  const Mover& mover = movers_[queue.movers[queue.head]];
  const double ready = mover.arrived + servers_[mover.movement].delay;
  push(std::max(ready, queue.free_at), Kind::leaves, lane.value);
  queue.is_active = true;
}

void QueueForecast::leave(const Event& event) {
  const LaneId lane{event.subject};
  Queue& queue = queues_[lane];
  const std::uint32_t subject = queue.movers[queue.head];
  Mover& mover = movers_[subject];
  const RoadId road = (*mover.route)[mover.position];
  const RoadId next = (*mover.route)[mover.position + 1];
  if (occupancy_[next] >= servers_.storage(next)) {  // the queue ahead has come back to here
    if (queue.blocked_since < 0) queue.blocked_since = event.time;
    if (event.time - queue.blocked_since < options_.blocked_patience)
      return push(event.time + options_.blocked_retry, Kind::leaves, lane.value);
  }
  queue.blocked_since = -1;
  queue.passed[queue.head].left = static_cast<float>(event.time);
  ++queue.head;
  queue.is_active = false;
  const Movement& movement = servers_[mover.movement];
  queue.free_at = event.time + movement.headway * discharge_.factor(lane);
  --occupancy_[road];
  ++occupancy_[next];
  ++mover.position;
  push(event.time + movement.through + servers_.free_flow(next), Kind::reaches_end, subject);
  if (queue.head < queue.movers.size()) schedule_head(lane);
}

void QueueForecast::tabulate() {
  const std::size_t bins = options_.bins;
  lane_wait_.resize(bins);
  for (std::size_t i = 0; i < network_.roads.size(); ++i) {
    const Road& road = network_.roads[RoadId{i}];
    if (road.function != RoadFunction::normal) continue;
    const std::span<float> waits(wait_.data() + i * bins, bins);
    std::size_t total = 0;
    for (std::uint32_t k = 0; k < road.lane_count; ++k)
      total += queues_[LaneId{road.first_lane.value + k}].passed.size();
    if (total == 0) {  // nobody will be there: what each turn's best lane takes, in the mean
      float sum = 0;
      for (std::size_t m = servers_.first_of(RoadId{i}); m < servers_.last_of(RoadId{i}); ++m) {
        double least = servers_.means(servers_.lanes(MovementId{m}).front()).delay;
        for (const LaneId lane : servers_.lanes(MovementId{m}))
          least = std::min(least, servers_.means(lane).delay);
        sum += static_cast<float>(least);
      }
      const std::size_t count = servers_.last_of(RoadId{i}) - servers_.first_of(RoadId{i});
      std::fill(waits.begin(), waits.end(), count > 0 ? sum / static_cast<float>(count) : 0.0F);
      continue;
    }
    std::fill(waits.begin(), waits.end(), 0.0F);
    for (std::uint32_t k = 0; k < road.lane_count; ++k) {
      const LaneId lane{road.first_lane.value + k};
      const std::size_t own = queues_[lane].passed.size();
      if (own == 0) continue;
      tabulate_lane(lane, lane_wait_);
      const float weight = static_cast<float>(own) / static_cast<float>(total);
      for (std::size_t b = 0; b < bins; ++b) waits[b] += weight * lane_wait_[b];
    }
  }
}

void QueueForecast::tabulate_lane(LaneId lane, std::span<float> waits) const {
  const auto& passed = queues_[lane].passed;
  const Servers::LaneMeans& means = servers_.means(lane);
  const double headway = means.headway * discharge_.factor(lane);
  const double bin = to_seconds(options_.bin);
  std::size_t next = 0;
  double last_left = -1e9;
  for (std::size_t b = 0; b < waits.size(); ++b) {
    const double time = (static_cast<double>(b) + 0.5) * bin;
    for (; next < passed.size() && passed[next].arrived <= time; ++next) {
      const float left = passed[next].left;
      // Who is still there at the horizon leaves after the one before, and not before the horizon.
      last_left = left < still_there ? static_cast<double>(left) : std::max(last_left + headway, horizon_);
    }
    double leave = time + means.delay;
    if (next > 0) leave = std::max(leave, last_left + headway);
    waits[b] = static_cast<float>(leave - time);
  }
}

}  // namespace thalweg
