// SPDX-License-Identifier: Apache-2.0
#include "traffic/memory.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace thalweg {
namespace {

void learn(RememberedTime& known, const LivedTime& lived) {
  ++known.days;
  known.observations += lived.observations;
  const double step = std::max(1.0 / static_cast<double>(known.days), Memory::least_step);
  known.seconds += step * (lived.seconds - known.seconds);
}

}  // namespace

void Memory::learn(const std::vector<std::vector<LivedTime>>& day, std::vector<RememberedTrip> new_trips,
                   double new_commute) {
  ++days;
  if (times.size() < day.size()) times.resize(day.size());
  for (std::size_t at = 0; at < day.size(); ++at) {
    std::vector<RememberedTime> merged;
    auto known = times[at].begin();
    for (const LivedTime& lived : day[at]) {
      while (known != times[at].end() && known->road < lived.road) merged.push_back(*known++);
      const bool is_known = known != times[at].end() && known->road == lived.road;
      merged.push_back(is_known ? *known++ : RememberedTime{.road = lived.road});
      thalweg::learn(merged.back(), lived);
    }
    merged.insert(merged.end(), known, times[at].end());
    times[at] = std::move(merged);
  }
  if (!trips.empty() && new_commute > commute) {
    commute += doubt * (new_commute - commute);
    return;
  }
  commute = new_commute;
  trips = std::move(new_trips);
  std::stable_sort(trips.begin(), trips.end(), [](const RememberedTrip& a, const RememberedTrip& b) {
    return std::tie(a.depart, a.vehicle) < std::tie(b.depart, b.vehicle);
  });
}

}  // namespace thalweg
