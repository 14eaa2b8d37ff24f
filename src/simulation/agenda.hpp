// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "core/hash.hpp"
#include "demand/demand.hpp"

namespace thalweg {

/// Whether a vehicle is ours when `share` of them are: the same vehicles in every arm and run.
inline bool is_equipped(const DemandVehicle& vehicle, double share) {
  return !vehicle.fixed && unit_hash(vehicle.id + "#share") < share;
}

/// The vehicles' own clocks: when each of ours reconsiders.
class Agenda {
 public:
  /// `period` 0: everybody is due at every step. `share`: so much of the vehicles is ours. `early`: from when
  /// they are loaded on, and not only from when they want to depart.
  Agenda(const Demand& demand, Millis period, double share, bool early) : period_(period), early_(early) {
    entries_.resize(demand.vehicles.size());
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const DemandVehicle& vehicle = demand.vehicles[VehicleId{i}];
      Entry& entry = entries_[VehicleId{i}];
      entry.depart = vehicle.depart.value_or(0);
      entry.ours = is_equipped(vehicle, share);
      entry.phase =
          period_ > 0 ? static_cast<Millis>(unit_hash(vehicle.id) * static_cast<double>(period_)) : 0;
    }
  }

  [[nodiscard]] bool ours(VehicleId vehicle) const { return entries_[vehicle].ours; }
  [[nodiscard]] bool departed(VehicleId vehicle) const { return entries_[vehicle].state == State::running; }

  /// Due at the step that will insert it, before that step.
  void on_loaded(VehicleId vehicle, Millis now) {
    entries_[vehicle].state = State::loaded;
    const Millis depart = std::max(now, entries_[vehicle].depart);
    schedule(vehicle, early_ ? std::min(next_turn(vehicle, now), depart) : depart);
  }
  /// A turn that came within the step that inserted it is taken now.
  void on_departed(VehicleId vehicle, Millis now) {
    entries_[vehicle].state = State::running;
    if (entries_[vehicle].due > now) schedule(vehicle, next_turn(vehicle, now));
  }
  void on_arrived(VehicleId vehicle) { entries_[vehicle] = {}; }
  /// One that was asked before it wants to depart is asked again when it does, with what is seen by then.
  void reschedule(VehicleId vehicle, Millis now) {
    const Entry& entry = entries_[vehicle];
    const bool is_to_come = entry.state == State::loaded && entry.depart > now;
    schedule(vehicle, is_to_come ? entry.depart : next_turn(vehicle, now));
  }

  /// Takes out who is due by `now`, in the order of their ids.
  void take_due(Millis now, std::vector<VehicleId>& due) {
    due.clear();
    while (!queue_.empty() && queue_.top().first <= now) {
      const auto [time, vehicle] = queue_.top();
      queue_.pop();
      if (entries_[vehicle].due != time || entries_[vehicle].state == State::away) continue;
      entries_[vehicle].due = infinity;
      due.push_back(vehicle);
    }
    std::sort(due.begin(), due.end());
  }

 private:
  enum class State : std::uint8_t { away, loaded, running };
  struct Entry {
    Millis depart = 0;
    Millis phase = 0;
    Millis due = infinity;
    State state = State::away;
    bool ours = false;
  };

  /// The first moment after `now` that lies in the vehicle's phase.
  [[nodiscard]] Millis next_turn(VehicleId vehicle, Millis now) const {
    if (period_ == 0) return now + 1;
    const Millis since = now - entries_[vehicle].phase;
    const Millis turns = since >= 0 ? since / period_ : -((-since + period_ - 1) / period_);
    return entries_[vehicle].phase + (turns + 1) * period_;
  }

  void schedule(VehicleId vehicle, Millis time) {
    if (!entries_[vehicle].ours) return;
    entries_[vehicle].due = time;
    queue_.emplace(time, vehicle);
  }

  using Turn = std::pair<Millis, VehicleId>;
  Millis period_;
  bool early_;
  IdVector<VehicleId, Entry> entries_;
  std::priority_queue<Turn, std::vector<Turn>, std::greater<>> queue_;
};

}  // namespace thalweg
