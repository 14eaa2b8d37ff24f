// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "network/network.hpp"

namespace thalweg {

/// For how long one link of a signal may be driven in a cycle, in s.
struct Green {
  double priority = 0;  ///< nobody to give way to
  double permissive = 0;
  double yellow = 0;
  double cycle = 0;
};

Green green_of(const SignalProgramme& programme, std::size_t link);

/// A link that leads onto a road, and the s from its stop line to the end of that road.
struct Feeder {
  std::size_t link;
  double travel;
};

/// For each second of the programme's cycle, s until one of the links may be driven: 0 while one may; the
/// whole cycle where none ever opens. Empty where nobody knows: no phases, or phases of broken seconds.
std::vector<std::size_t> seconds_until_open(const SignalProgramme& programme,
                                            std::span<const std::size_t> links);

/// The mean wait at the end of a road whose links all belong to the signal that lets vehicles onto it, in s:
/// they come in its green, and mostly find the next stop line green as well. Without a value where no feeder
/// or none of `links` ever opens. `permissive`: worth of a green that has to give way.
std::optional<double> coordinated_wait(const SignalProgramme& programme, std::span<const Feeder> feeders,
                                       std::span<const std::size_t> links, double permissive);

}  // namespace thalweg
