// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "routing/strategy.hpp"
#include "support/queueing.hpp"

namespace thalweg::testing {

/// What a strategy that looks ahead is shown at every look: a fleet on roads of which nothing has been
/// measured, without signals, open but for what is changed from the begin on.
struct Watched {
  Watched(Network net, std::size_t vehicles, std::vector<LaneChange> changes = {})
      : network(std::move(net)), driven(network, vehicles), conditions(network, std::move(changes)) {
    conditions.advance(0);
  }
  Watched(const Watched&) = delete;  // its parts refer to each other
  Watched& operator=(const Watched&) = delete;

  /// A look at the traffic, `now` after the begin; refers to this.
  [[nodiscard]] TrafficState look(const std::vector<Driven::At>& places, Millis now) {
    driven.look(places);
    return {.now = now,
            .network = network,
            .demand = driven.demand,
            .fleet = driven.fleet,
            .measured = measured,
            .observations = {},
            .conditions = conditions,
            .programmes = programmes,
            .changed_signals = {},
            .following = {}};
  }

  Network network;
  Driven driven;
  MeasuredTimes measured{network, 180'000, 3'000};
  Conditions conditions;
  IdVector<SignalId, SignalProgramme> programmes;
};

}  // namespace thalweg::testing
