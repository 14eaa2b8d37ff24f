// SPDX-License-Identifier: Apache-2.0
#include "traffic/residuals.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace thalweg {
namespace {

double clamped(double seconds, double most) { return std::clamp(seconds, -most, most); }

}  // namespace

Residuals::Residuals(const Network& network, const ResidualOptions& options)
    : network_(network),
      options_(options),
      sums_(network.roads.size()),
      late_sums_(network.roads.size()),
      lasting_(network.roads.size(), 0),
      passing_(network.roads.size(), 0),
      late_(network.roads.size(), 0) {}

void Residuals::Sums::fade(double share) {
  weight *= share;
  over *= share;
}

void Residuals::Sums::add(double more, double seconds) {
  weight += more;
  over += more * seconds;
}

void Residuals::learn(const Servers& servers, const Level& level, const QueueTable& expected,
                      const MeasuredTimes& measured, double seconds, Millis now) {
  const double fading = std::exp(-seconds / options_.memory);
  const double left_then = passing_left(options_.lead);
  const double share = seconds / measured.window();  // of the window that is new
  // What was measured stands for the middle of its window.
  const Millis comparable = now - from_seconds(options_.lead + measured.window() / 2);
  while (outlooks_.size() > 1 && outlooks_[1].made <= comparable) outlooks_.pop_front();
  const Outlook* then = !outlooks_.empty() && outlooks_[0].made <= comparable ? &outlooks_[0] : nullptr;
  Outlook outlook{.made = now, .times = std::vector<float>(network_.roads.size(), 0)};
  for (std::size_t i = 0; i < network_.roads.size(); ++i) {
    const RoadId road{i};
    Sums& now_sums = sums_[road];
    Sums& late_sums = late_sums_[road];
    now_sums.fade(fading);
    late_sums.fade(fading);
    const bool is_normal = network_.roads[road].function == RoadFunction::normal;
    const double free_flow = std::max(0.1, servers.free_flow(road));
    const double alone = std::max(0.1, free_flow + level.extra(servers, road));
    const double model = alone + (is_normal ? expected.wait_after(road, free_flow) : 0);
    const Passage passage = measured.passage(road);
    const double longest = is_normal ? options_.longest_road : options_.longest_junction;
    const double seen =
        std::min(longest, passage.vehicle_seconds / std::max(passage.traversals, options_.least_traversals));
    const double weight = std::max(passage.traversals, passage.vehicle_seconds / model);  // 0: nobody there
    now_sums.add(weight * share, clamped(seen - model, options_.most_lasting));
    if (then != nullptr && is_normal)
      late_sums.add(weight * share, clamped(seen - static_cast<double>(then->times[i]), options_.most_late));
    lasting_[road] = now_sums.mean(options_.prior);
    passing_[road] = (seen - model - lasting_[road]) * weight / (weight + options_.prior);
    late_[road] = late_sums.mean(options_.prior);
    if (!is_normal) continue;
    outlook.times[i] = static_cast<float>(alone + expected.wait_after(road, free_flow + options_.lead) +
                                          lasting_[road] + passing_[road] * left_then);
  }
  outlooks_.push_back(std::move(outlook));
}

}  // namespace thalweg
