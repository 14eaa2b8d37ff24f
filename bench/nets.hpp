// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/time.hpp"
#include "graph/digraph.hpp"
#include "routing/strategy.hpp"

namespace thalweg::bench {

/// A graph to measure on, with free-flow costs and where its vertices lie (m), for gluing.
struct Net {
  std::string name;
  Digraph graph;
  std::vector<Millis> costs;
  std::vector<double> x;
  std::vector<double> y;
};

/// The net for passenger cars.
Net read_net(const std::filesystem::path& file);

/// columns x rows copies side by side; neighbours are joined both ways by 32 roads at their common border, so
/// that the whole falls apart at borders as real regions do.
Net glued(const Net& net, std::size_t columns, std::size_t rows);

/// The paper's grid, costs at random.
Net grid(std::size_t side);

/// `count` travellers by seed, `per_destination` to each, all of whom can arrive.
std::vector<Traveller> travellers(const Net& net, std::size_t count, std::size_t per_destination);

/// Live costs of another round: every arc between its free flow and three times that.
std::vector<Millis> live_costs(const Net& net, std::uint64_t round);

}  // namespace thalweg::bench
