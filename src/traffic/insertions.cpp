// SPDX-License-Identifier: Apache-2.0
#include "traffic/insertions.hpp"

#include <algorithm>

namespace thalweg {

Insertions::Insertions(const Network& network, const Servers& servers, std::size_t vehicles,
                       const InsertionOptions& options)
    : servers_(servers),
      options_(options),
      lines_(network.lanes.size()),
      line_of_(network.lanes.size()),
      first_(network.roads.size()),
      has_one_line_(network.roads.size(), true),
      is_in_(vehicles, false) {
  for (std::size_t i = 0; i < network.roads.size(); ++i) form_lines(network, RoadId{i});
}

void Insertions::form_lines(const Network& network, RoadId road) {
  const auto lanes = network.roads[road].lanes();
  for (const LaneId lane : lanes) line_of_[lane] = lane;
  const auto join = [&](LaneId one, LaneId other) {
    const LaneId from = line_of_[one];
    for (const LaneId lane : lanes) {
      if (line_of_[lane] == from) line_of_[lane] = line_of_[other];
    }
  };
  for (std::size_t m = servers_.first_of(road); m < servers_.last_of(road); ++m) {
    const auto shared = servers_.lanes(MovementId{m});
    for (const LaneId lane : shared) join(lane, shared.front());
  }
  // Where no movement leads on, one stands in the first line.
  const auto leads_on = [&](LaneId lane) {
    return servers_.carries(lane) && servers_.means(lane).headway > 0;
  };
  for (const LaneId lane : lanes) {
    if (!first_[road].valid() && leads_on(lane)) first_[road] = lane;
  }
  if (!first_[road].valid()) first_[road] = network.roads[road].first_lane;
  for (const LaneId lane : lanes) {
    if (!leads_on(lane)) join(lane, first_[road]);
  }
  for (const LaneId lane : lanes) {
    if (line_of_[lane] != line_of_[first_[road]]) has_one_line_[road] = false;
  }
  for (const LaneId line : lanes) {
    int count = 0;
    for (const LaneId lane : lanes) count += servers_.carries(lane) && line_of_[lane] == line ? 1 : 0;
    lines_[line].usual_headway = lines_[line].headway = options_.headway / std::max(1, count);
  }
}

void Insertions::observe(const Fleet& fleet, Millis now) {
  if (last_lesson_ < 0) last_lesson_ = last_look_ = now;
  const double unseen = to_seconds(now - last_look_) / 2;  // since it got in, in the mean
  last_look_ = now;
  for (const VehicleId vehicle : fleet.present()) {
    const FleetVehicle& own = fleet[vehicle];
    const bool waits = own.state == FleetVehicle::State::waiting;
    const bool is_of_interest = waits ? own.depart <= now : !is_in_[vehicle] && !own.is_lost;
    if (!is_of_interest || own.route.empty()) continue;
    const bool ends_here = own.position + 1 == own.route.size();
    const LaneId id = line(own.route[own.position], ends_here ? RoadId{} : own.route[own.position + 1]);
    Line& line = lines_[id];
    if (waits) {
      if (line.waiting++ == 0) wanted_.push_back(id);
      continue;
    }
    is_in_[vehicle] = true;
    ++line.inserted;
    ++line.seen;
    line.waited += to_seconds(now - own.depart) - unseen;
  }
  for (const LaneId id : wanted_) {
    ++lines_[id].busy_looks;
    lines_[id].waiting = 0;
  }
  wanted_.clear();
  ++looks_;
  if (now - last_lesson_ < options_.interval) return;
  for (Line& line : lines_) learn(line, to_seconds(now - last_lesson_));
  last_lesson_ = now;
  looks_ = 0;
}

void Insertions::learn(Line& line, double seconds) const {
  if (line.busy_looks == looks_) {
    const double seen = std::min(options_.slowest, seconds / std::max(1, line.inserted));
    line.headway += options_.towards_slower * (seen - line.headway);
  } else if (line.inserted * line.headway > seconds) {  // it has shown that it is faster
    line.headway = seconds / line.inserted;
  } else {
    line.headway += options_.towards_usual * (line.usual_headway - line.headway);
  }
  line.seen *= options_.kept;
  line.waited *= options_.kept;
  line.inserted = 0;
  line.busy_looks = 0;
}

LaneId Insertions::line(RoadId road, RoadId next) const {
  const MovementId turn = next.valid() ? servers_.find(road, next) : MovementId{};
  return line_of_[turn.valid() ? servers_.lanes(turn).front() : first_[road]];
}

std::optional<double> Insertions::wait(LaneId line) const {
  const Line& own = lines_[line];
  if (own.seen < 0.5) return std::nullopt;
  return std::max(0.0, own.waited / own.seen);
}

}  // namespace thalweg
