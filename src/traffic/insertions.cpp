// SPDX-License-Identifier: Apache-2.0
#include "traffic/insertions.hpp"

#include <algorithm>

namespace thalweg {

Insertions::Insertions(const Servers& servers, std::size_t vehicles, const InsertionOptions& options)
    : servers_(servers), options_(options), lines_(servers.size()), is_in_(vehicles, false) {
  for (std::size_t i = 0; i < servers.size(); ++i) {
    const double usual = servers.insertion_headway(servers[MovementId{i}].from);
    lines_[MovementId{i}] = {.usual_headway = usual, .headway = usual};
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
    if (!is_of_interest) continue;
    if (!waits) is_in_[vehicle] = true;
    if (own.position + 1 >= own.route.size()) continue;
    const MovementId turn = servers_.find(own.route[own.position], own.route[own.position + 1]);
    if (!turn.valid()) continue;
    Line& line = lines_[turn];
    if (waits) {
      if (line.waiting++ == 0) wanted_.push_back(turn);
    } else {
      ++line.inserted;
      ++line.seen;
      line.waited += to_seconds(now - own.depart) - unseen;
    }
  }
  for (const MovementId turn : wanted_) {
    ++lines_[turn].busy_looks;
    lines_[turn].waiting = 0;
  }
  wanted_.clear();
  ++looks_;
  if (now - last_lesson_ < options_.interval) return;
  for (Line& line : lines_) learn(line, to_seconds(now - last_lesson_));
  last_lesson_ = now;
  looks_ = 0;
}

void Insertions::learn(Line& line, double seconds) const {
  const bool is_busy = line.busy_looks == looks_;
  if (is_busy) {
    line.busy = options_.kept * line.busy + seconds;
    line.got_in = options_.kept * line.got_in + line.inserted;
  } else if (line.inserted * line.headway > seconds) {  // it has shown that it is faster
    line.busy = seconds;
    line.got_in = line.inserted;
  } else {
    line.busy *= options_.faded;
    line.got_in *= options_.faded;
  }
  line.headway = (line.busy + options_.usual * line.usual_headway) / (line.got_in + options_.usual);
  line.seen *= options_.faded;
  line.waited *= options_.faded;
  line.inserted = 0;
  line.busy_looks = 0;
}

std::optional<double> Insertions::wait(MovementId turn) const {
  const Line& line = lines_[turn];
  if (line.seen < 0.5) return std::nullopt;
  return std::max(0.0, line.waited / line.seen);
}

}  // namespace thalweg
