// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "routing/hindsight.hpp"
#include "routing/strategy.hpp"
#include "traffic/bookings.hpp"
#include "traffic/discharge.hpp"
#include "traffic/last_roads.hpp"
#include "traffic/level.hpp"
#include "traffic/overrun.hpp"
#include "traffic/phase_lengths.hpp"
#include "traffic/queue_forecast.hpp"
#include "traffic/residuals.hpp"
#include "traffic/servers.hpp"
#include "traffic/timed_costs.hpp"

namespace thalweg {

/// All that a strategy with a forecast learns and expects of the traffic, brought up to date at every look
/// and looked ahead from anew once a round.
class Foresight {
 public:
  /// With a memory, those who set out on the day before are expected again.
  explicit Foresight(const TrafficState& first, const Memory* memory = nullptr,
                     const ForecastOptions& options = {}, const ServerOptions& servers = {});
  Foresight(const Foresight&) = delete;  // its parts refer to each other
  Foresight& operator=(const Foresight&) = delete;

  /// True after a new forecast.
  bool watch(const TrafficState& state);
  /// Whether `watch` will look ahead anew, which takes everybody's position on its road.
  [[nodiscard]] bool is_round_due(Millis now) const {
    return now >= next_round_ || conditions_.version() != conditions_version_;
  }

  [[nodiscard]] const Network& network() const { return network_; }
  [[nodiscard]] Millis now() const { return now_; }
  [[nodiscard]] Millis forecast_at() const { return forecast_at_; }
  [[nodiscard]] const QueueTable& table() const { return forecast_.table(); }
  [[nodiscard]] Expectation expected() const {
    return {.forecast = table(),
            .bookings = bookings_,
            .servers = servers_,
            .level = level_,
            .residuals = residuals_,
            .conditions = conditions_};
  }
  /// A whole crossing of the road, nobody in the way, as it is driven.
  [[nodiscard]] Millis driven(Millis free_flow) const {
    return static_cast<Millis>(level_.pace() * static_cast<double>(free_flow));
  }
  /// Share of a road's delay that those meet who end their trip there; all of it where nobody drives on.
  [[nodiscard]] double share_of_last_delay(RoadId road) const {
    return servers_.leads_on(road) ? last_roads_.share() : 1;
  }
  /// From now until a vehicle that has not departed gets on its first road to drive on to the second; it
  /// wants to in `wanted`. Another line than its own counts as faster only where those who got in there
  /// lately have waited for less: it has no place there yet.
  [[nodiscard]] Millis insertion(VehicleId vehicle, Millis wanted, RoadId first, RoadId second) const;
  /// Whether it depends on the second one.
  [[nodiscard]] bool has_lines(RoadId first) const { return !discharge_.insertions().has_one_line(first); }
  struct Leaving {
    RoadId road;
    Millis at;  ///< not before now
  };
  /// The road that a vehicle is on or about to enter, and when it leaves that by its own place in the queue.
  /// Nothing where the last forecast did not have it there.
  [[nodiscard]] std::optional<Leaving> leaving(VehicleId vehicle) const;

  /// Who gets on the road now comes to a signal that is known (SignalWaits) and leaves him a choice, and
  /// finds next to nobody before him: what it shows then decides when he is through.
  [[nodiscard]] bool what_is_shown_counts(RoadId road) const;

  Bookings& bookings() { return bookings_; }
  Hindsight& hindsight() { return hindsight_; }
  Overrun& overrun() { return overrun_; }
  [[nodiscard]] const Overrun& overrun() const { return overrun_; }

 private:
  void see_signals(const TrafficState& state);

  /// With 30 s vehicles in twin heavy arrive 4 % later (docs/tried.md, "What it costs").
  static constexpr Millis round = 20'000;

  const Network& network_;
  const Conditions& conditions_;
  const Fleet& fleet_;
  Servers servers_;
  IdVector<SignalId, std::optional<PhaseLengths>> phase_lengths_;  ///< of those that follow the traffic
  Discharge discharge_;
  QueueForecast forecast_;
  Level level_;
  Residuals residuals_;
  LastRoads last_roads_;
  Bookings bookings_;
  Hindsight hindsight_;
  Overrun overrun_;
  Millis now_ = 0;
  Millis forecast_at_ = 0;
  Millis next_round_ = 0;
  std::uint32_t conditions_version_ = 0;
};

}  // namespace thalweg
