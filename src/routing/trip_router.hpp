// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "network/network.hpp"
#include "routing/strategy.hpp"

namespace thalweg {

/// Routes trips by the names of their roads on times that stand still, all of them as one batch.
class TripRouter {
 public:
  struct Setting {
    TurnPenalties penalties{};
    std::vector<std::string> weight_files{};  ///< may be given more than once; the dearest counts
    Millis time = 0;                          ///< whose weights are used
  };
  TripRouter(const Network& network, Setting setting, std::unique_ptr<Strategy> strategy);

  /// Adds a trip of a class and top speed (m/s) along these roads (a zone's source and sink may be its ends);
  /// what is wrong with it is returned, and nothing when it is well.
  std::string add(VehicleClass vehicle_class, double max_speed, std::span<const std::string_view> roads);

  void route() { strategy_->decide(traffic_, travellers_, decisions_); }

  struct Found {
    std::string edges;
    Millis cost = 0;
  };
  /// Of the i-th trip added without a problem; nullopt: there is no way.
  [[nodiscard]] std::optional<Found> result(std::size_t i) const;

 private:
  std::size_t traffic_of(VehicleClass vehicle_class, double max_speed);

  const Network& network_;
  Setting setting_;
  std::unique_ptr<Strategy> strategy_;
  std::vector<std::string> road_names_;  ///< for messages; filled when one is needed
  std::map<VehicleClass, std::unique_ptr<RoadGraph>> graphs_;
  std::map<std::pair<VehicleClass, double>, std::size_t> traffic_index_;
  std::vector<ClassTraffic> traffic_;
  std::vector<Traveller> travellers_;
  std::vector<Decision> decisions_;
};

}  // namespace thalweg
