// SPDX-License-Identifier: Apache-2.0
#include "traffic/waiting_line.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

namespace thalweg {

void WaitingLine::clear() {
  vehicles_.clear();
  head_ = 0;
  free_at_ = long_ago;
}

void WaitingLine::join(std::uint32_t mover, float wanted) {
  vehicles_.push_back({.mover = mover, .wanted = wanted, .entered = std::numeric_limits<float>::infinity()});
}

void WaitingLine::let_in_first(double time, double headway) {
  vehicles_[head_++].entered = static_cast<float>(time);
  free_at_ = time + headway;
}

double WaitingLine::when(double wanted, double headway) const {
  const auto behind = std::upper_bound(
      vehicles_.begin(), vehicles_.end(), wanted,
      [](double time, const Vehicle& one) { return time < static_cast<double>(one.wanted); });
  const double alone = std::max(0.0, wanted);
  if (behind == vehicles_.begin()) return alone;
  return std::max(alone, static_cast<double>(std::prev(behind)->entered) + headway);
}

}  // namespace thalweg
