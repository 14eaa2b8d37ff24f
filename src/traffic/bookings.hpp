// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "traffic/queue_table.hpp"

namespace thalweg {

/// The paper's reserve table ("each member books the resources on its way"): what those who decided since the
/// forecast have changed about it. A vehicle that changes its way gives back its places in the queues of the
/// old one and takes places in those of the new one, each at its time; who decides after it sees the queues
/// as they will be then. The next forecast has everybody on their new ways, and begins with an empty table.
class Bookings {
 public:
  Bookings(const Network& network, const QueueTable& forecast);

  /// After a new forecast.
  void clear();
  /// `count` vehicles more (below 0: less) reach the end of the road at `time`, in s from the forecast on.
  void book(RoadId road, double time, double count);
  /// The roads booked since the last call, ascending; their waits are up to date then.
  [[nodiscard]] std::vector<RoadId> take_changed();

  /// s at the end of the road for one that reaches it in this bin of the forecast.
  [[nodiscard]] float wait(RoadId road, std::size_t bin) const {
    return forecast_.wait(road, bin) +
           (row_[road] == none ? 0.0F : more_[row_[road] * forecast_.bins() + bin]);
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  void update(RoadId road);

  const QueueTable& forecast_;
  IdVector<RoadId, std::size_t> row_;  ///< of the roads that somebody booked; none: the others
  std::vector<RoadId> booked_;         ///< by row
  std::vector<float> count_;           ///< vehicles more than forecast, by row and bin
  std::vector<float> more_;            ///< s of wait more than forecast, by row and bin
  std::vector<RoadId> changed_;
};

}  // namespace thalweg
