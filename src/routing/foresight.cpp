// SPDX-License-Identifier: Apache-2.0
#include "routing/foresight.hpp"

#include <algorithm>
#include <utility>

namespace thalweg {

Foresight::Foresight(const TrafficState& first, const Memory* memory, const ForecastOptions& options,
                     const ServerOptions& servers)
    : network_(first.network),
      conditions_(first.conditions),
      fleet_(first.fleet),
      servers_(first.network, servers),
      phase_lengths_(first.network.signals.size()),
      discharge_(first.network, servers_, first.demand),
      forecast_(first.network, servers_, discharge_, options),
      level_(first.network),
      residuals_(first.network),
      last_roads_(first.demand.vehicles.size()),
      bookings_(first.network, forecast_.table()),
      hindsight_(first.demand.vehicles.size()),
      overrun_(first.demand.vehicles.size()) {
  if (memory == nullptr) return;
  std::vector<Departures::Departure> departures;
  for (const RememberedTrip& trip : memory->trips)
    departures.push_back({.time = trip.depart, .route = trip.route});
  forecast_.departures().know(std::move(departures));
}

bool Foresight::watch(const TrafficState& state) {
  now_ = state.now;
  see_signals(state);
  for (const RoadId road : state.conditions.roads())
    servers_.set_free_flow(road, state.conditions.crossing(road));
  discharge_.observe(state.fleet, state.now);
  forecast_.departures().observe(state.fleet, state.now);
  hindsight_.observe(state.fleet, state.now);
  overrun_.observe(state.fleet, state.now);
  last_roads_.observe(state.fleet, expected(), state.now);
  if (!is_round_due(state.now)) return false;
  conditions_version_ = state.conditions.version();
  const bool is_in_turn = state.now >= next_round_ && state.now < next_round_ + round;
  next_round_ = (is_in_turn ? next_round_ : state.now) + round;
  forecast_at_ = state.now;
  forecast_.run(state.fleet, level_, state.now);
  level_.learn(servers_, forecast_.table(), state.measured, to_seconds(round));
  residuals_.learn(servers_, level_, forecast_.table(), state.measured, to_seconds(round), state.now);
  bookings_.clear();
  return true;
}

void Foresight::see_signals(const TrafficState& state) {
  for (const SignalId signal : state.changed_signals) {
    const SignalProgramme& programme = state.programmes[signal];
    servers_.set_programme(signal, programme);
    phase_lengths_[signal].reset();
    if (programme.follows_traffic) phase_lengths_[signal].emplace(programme);
  }
  for (const auto& [signal, shown] : state.following) {
    PhaseLengths& lengths = *phase_lengths_[signal];
    lengths.see(shown, state.now);
    const SignalProgramme& programme = lengths.programme();
    if (is_round_due(state.now) && lengths.take_means(state.now))
      servers_.set_programme(signal, programme);
    else if (programme.cycle_start)
      servers_.set_cycle_start(signal, *programme.cycle_start);
  }
}

Millis Foresight::insertion(VehicleId vehicle, Millis wanted, RoadId first, RoadId second) const {
  const FleetVehicle& own = fleet_[vehicle];
  const Millis since_forecast = now_ - forecast_at_;
  const Millis as_it_is = std::max(wanted, forecast_.insertion(vehicle) - since_forecast);
  const Insertions& insertions = discharge_.insertions();
  if (insertions.has_one_line(first)) return as_it_is;
  const LaneId line = insertions.line(first, second);
  if (line == insertions.line(first, own.route.size() > 1 ? own.route[1] : RoadId{})) return as_it_is;
  const auto seen = insertions.wait(line);
  if (!seen) return as_it_is;
  return std::max({wanted, own.depart + from_seconds(*seen) - now_,
                   forecast_.insertion(line, own.depart - forecast_at_) - since_forecast});
}

bool Foresight::what_is_shown_counts(RoadId road) const {
  constexpr double longest_queue = 3;  // s
  const std::size_t first = servers_.first_of(road);
  const std::size_t last = servers_.last_of(road);
  bool is_known = false;
  for (std::size_t i = first; i < last; ++i)
    is_known = is_known || servers_.signal_waits().knows(MovementId{i});
  if (!is_known || last - first < 2) return false;
  const double ahead = to_seconds(now_ - forecast_at_) + servers_.free_flow(road);
  return table().queue(road, table().bin_at(ahead)) <= longest_queue;
}

std::optional<Foresight::Leaving> Foresight::leaving(VehicleId vehicle) const {
  const QueueForecast::Leaving& foretold = forecast_.leaving(vehicle);
  const FleetVehicle& own = fleet_[vehicle];
  const std::size_t position = own.position + (own.on_junction ? 1 : 0);
  const bool is_there = foretold.road.valid() && !own.is_lost && position < own.route.size() &&
                        own.route[position] == foretold.road;
  if (!is_there) return {};
  return Leaving{.road = foretold.road, .at = std::max(now_, forecast_at_ + foretold.time)};
}

}  // namespace thalweg
