// SPDX-License-Identifier: Apache-2.0
#include "traffic/bookings.hpp"

#include <algorithm>
#include <utility>

namespace thalweg {

Bookings::Bookings(const Network& network, const QueueTable& forecast)
    : forecast_(forecast), row_(network.roads.size(), none) {}

void Bookings::clear() {
  for (const RoadId road : booked_) row_[road] = none;
  booked_.clear();
  count_.clear();
  more_.clear();
  changed_.clear();
}

void Bookings::book(RoadId road, double time, double count) {
  const std::size_t bins = forecast_.bins();
  if (time >= forecast_.horizon()) return;
  const std::size_t bin = forecast_.bin_at(time);
  if (row_[road] == none) {
    row_[road] = booked_.size();
    booked_.push_back(road);
    count_.resize(booked_.size() * bins, 0.0F);
    more_.resize(booked_.size() * bins, 0.0F);
  }
  count_[row_[road] * bins + bin] += static_cast<float>(count);
  changed_.push_back(road);
}

std::vector<RoadId> Bookings::take_changed() {
  std::sort(changed_.begin(), changed_.end());
  changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
  for (const RoadId road : changed_) update(road);
  return std::exchange(changed_, {});
}

/// A fluid queue beside that of the forecast: what comes on top is served when the server would have been
/// idle; what is taken away cannot make a queue shorter than none.
void Bookings::update(RoadId road) {
  const std::size_t bins = forecast_.bins();
  const double bin = to_seconds(forecast_.bin());
  const double headway = forecast_.headway(road);
  const std::size_t first = row_[road] * bins;
  double more = 0;  // s of work, at the beginning of the bin
  const auto within = [&](std::size_t b, double work, double idle) {
    const double least = b < bins ? -forecast_.queue(road, b) : 0;
    return work > 0 ? std::max(0.0, work - idle) : std::max(least, work);
  };
  for (std::size_t b = 0; b < bins; ++b) {
    const double work = static_cast<double>(count_[first + b]) * headway;
    const double busy = static_cast<double>(forecast_.arrivals(road, b)) * headway;
    const double idle = forecast_.queue(road, b) > 0 ? 0 : std::max(0.0, bin - busy);
    more_[first + b] = static_cast<float>(within(b, more + work / 2, idle / 2));
    more = within(b + 1, more + work, idle);
  }
}

}  // namespace thalweg
