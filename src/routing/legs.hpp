// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "routing/strategy.hpp"

namespace thalweg {

/// The way from one road that a traveller must pass to the next.
struct Leg {
  std::size_t vehicle_class;
  VertexId destination;
  VertexId origin;
  std::size_t traveller;
  std::size_t number;             ///< among the traveller's legs
  Millis cost = infinity;         ///< found: to the destination, its own road excluded
  std::vector<VertexId> roads{};  ///< found: after `origin`, up to the destination
};

/// The legs of a batch, those of one class and destination together, and where each such group starts.
class Legs {
 public:
  void collect(std::span<const Traveller> due);

  [[nodiscard]] std::size_t group_count() const { return first_.size() - 1; }
  [[nodiscard]] std::span<Leg> group(std::size_t i) {
    return std::span(legs_).subspan(first_[i], first_[i + 1] - first_[i]);
  }

  /// Joins each traveller's legs to a route and lets the rule choose. The groups are gone after that.
  void decide(std::span<const ClassTraffic> traffic, std::span<const Traveller> due, const ChoiceRule& rule,
              std::vector<Decision>& decisions);

 private:
  std::vector<Leg> legs_;
  std::vector<std::size_t> first_{0};  ///< of each group, and one past the last
};

}  // namespace thalweg
