// SPDX-License-Identifier: Apache-2.0
#include "traffic/toll_table.hpp"

#include <algorithm>
#include <cmath>

namespace thalweg {
namespace {

constexpr double adapting = 300;     ///< s after which a later one counts 1/e
constexpr double flow_period = 300;  ///< s that a flow is looked at, and that it lasts

/// Of the overflow delay: vehicles come out of other signals, and less at random than the formula has it (as
/// the upstream filter of the Highway Capacity Manual).
constexpr double filtered = 0.5;

/// s of one that is held up by who waits for room on a road that it does not want to get on, in headways of
/// that road. Above one, since it cannot go round, and those whom it holds up in turn are not counted.
constexpr double headways_held_up = 3;

/// d(x) = T / 4 (x - 1 + sqrt((x - 1)^2 + 4 x h / T)), T the period, h the headway: x d'(x), of `flow`
/// vehicles a second.
double of_overflow(double headway, double scatter, double flow) {
  const double x = std::min(1.0, headway * flow);  // above capacity there is a queue, whose toll is known
  const double root = std::sqrt((x - 1) * (x - 1) + 4 * x * scatter);
  return filtered * x * flow_period / 4 * (1 + (x - 1 + 2 * scatter) / root);
}

}  // namespace

TollTable::TollTable(std::size_t roads, Millis bin, std::size_t bins)
    : bin_(to_seconds(bin)), bins_(bins), toll_(roads * bins, 0.0F), overflow_(bins) {}

void TollTable::clear(RoadId road) {
  std::fill_n(toll_.begin() + static_cast<std::ptrdiff_t>(road.value * bins_), bins_, 0.0F);
}

void TollTable::add(RoadId road, float weight, const LaneQueue& lane) {
  count_waiting(lane);
  sum_arrivals(lane);
  find_overflow(lane);
  std::size_t next = 0;
  for (std::size_t b = 0; b < bins_; ++b) {
    const double time = (static_cast<double>(b) + 0.5) * bin_;
    while (next < lane.passed.size() && lane.passed[next].arrived <= time) ++next;
    const double most =
        std::max(of_queue(lane, next, time + static_cast<double>(lane.wait[b])), overflow_[b]);
    toll_[road.value * bins_ + b] += weight * static_cast<float>(most);
  }
}

void TollTable::add_spillback(RoadId road, double headway, std::span<const float> delayed) {
  double sum = 0;
  for (std::size_t b = bins_; b-- > 0;) {
    sum = sum * std::exp(-bin_ / adapting) + static_cast<double>(delayed[b]);
    toll_[road.value * bins_ + b] += static_cast<float>(headways_held_up * headway * sum);
  }
}

void TollTable::count_waiting(const LaneQueue& lane) {
  waiting_.assign(lane.passed.size() + 1, 0);
  for (std::size_t i = lane.passed.size(); i-- > 0;) {
    const double alone = static_cast<double>(lane.passed[i].arrived) + lane.delay;
    if (static_cast<double>(lane.passed[i].left) <= alone + lane.headway / 2) continue;
    const double behind =
        i + 1 < lane.passed.size() ? lane.passed[i + 1].arrived - lane.passed[i].arrived : 0;
    waiting_[i] = 1 + std::exp(-behind / adapting) * waiting_[i + 1];
  }
}

void TollTable::sum_arrivals(const LaneQueue& lane) {
  arrivals_.assign(bins_ + 1, 0);
  for (std::size_t b = 0; b < bins_; ++b)
    arrivals_[b + 1] = arrivals_[b] + static_cast<double>(lane.arrivals[b]);
}

/// `next`: the first that comes later; `leaves`: s, when one that comes in between does.
double TollTable::of_queue(const LaneQueue& lane, std::size_t next, double leaves) const {
  const bool holds_up = next < lane.passed.size() &&
                        leaves + lane.headway > static_cast<double>(lane.passed[next].arrived) + lane.delay;
  return holds_up ? lane.headway * std::max(1.0, waiting_[next]) : 0;
}

void TollTable::find_overflow(const LaneQueue& lane) {
  const auto half = static_cast<std::size_t>(flow_period / bin_ / 2);
  for (std::size_t b = 0; b < bins_; ++b) {
    const std::size_t from = b > half ? b - half : 0;
    const std::size_t to = std::min(bins_, b + half + 1);
    overflow_[b] = (arrivals_[to] - arrivals_[from]) / (bin_ * static_cast<double>(to - from));
  }
  const double scatter = lane.headway / flow_period;
  for (double& one : overflow_) one = of_overflow(lane.headway, scatter, one);  // several at once
}

}  // namespace thalweg
