// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "demand/demand.hpp"
#include "routing/strategy.hpp"
#include "traffic/conditions.hpp"
#include "traffic/measured.hpp"

namespace thalweg {

/// The traffic as each class of vehicles sees it that may be re-routed, brought up to date when it is asked
/// for.
class LiveTraffic {
 public:
  LiveTraffic(const Network& network, const Demand& demand, const TurnPenalties& penalties);

  /// Index of a class; one of a vehicle of the demand that is not fixed.
  [[nodiscard]] std::size_t index_of(VehicleClass vehicle_class) const {
    return *index_[static_cast<std::size_t>(vehicle_class)];
  }
  [[nodiscard]] const RoadGraph& graph(std::size_t index) const { return *graphs_[index]; }
  [[nodiscard]] const ClassTraffic& operator[](std::size_t index) const { return traffic_[index]; }
  [[nodiscard]] std::span<const ClassTraffic> all() const { return traffic_; }

  /// The next `refresh` of each class reads the measurements again.
  void expire() { fresh_.assign(traffic_.size(), false); }
  void refresh(std::size_t index, const MeasuredTimes& measured, const Conditions& conditions);

 private:
  std::array<std::optional<std::size_t>, 64> index_;
  std::vector<std::unique_ptr<RoadGraph>> graphs_;
  std::vector<ClassTraffic> traffic_;
  std::vector<bool> fresh_;
};

}  // namespace thalweg
