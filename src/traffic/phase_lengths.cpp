// SPDX-License-Identifier: Apache-2.0
#include "traffic/phase_lengths.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace thalweg {

PhaseLengths::PhaseLengths(SignalProgramme programme) : programme_(std::move(programme)) {
  for (SignalPhase& phase : programme_.phases) {
    means_.push_back(to_seconds(phase.duration));
    phase.duration = from_seconds(std::round(means_.back()));
  }
}

void PhaseLengths::see(const ShownPhase& shown, Millis now) {
  if (shown.index >= count()) return;
  if (last_ && shown.index != last_->index) learn(shown);
  last_ = shown;
  place_cycle(now);
}

void PhaseLengths::learn(const ShownPhase& shown) {
  constexpr double newest = 0.2;  // weight of the newest length
  double length = to_seconds(shown.since - last_->since);
  for (std::size_t i = (last_->index + 1) % count(); i != shown.index; i = (i + 1) % count())
    length -= means_[i];
  double& mean = means_[last_->index];
  if (length > 0) mean += newest * (length - mean);
}

bool PhaseLengths::take_means(Millis now) {
  constexpr double other = 2;  // s
  double difference = 0;
  for (std::size_t i = 0; i < count(); ++i)
    difference = std::max(difference, std::abs(means_[i] - to_seconds(programme_.phases[i].duration)));
  if (difference < other) return false;
  for (std::size_t i = 0; i < count(); ++i)
    programme_.phases[i].duration = from_seconds(std::max(1.0, std::round(means_[i])));
  if (last_) place_cycle(now);
  return true;
}

void PhaseLengths::place_cycle(Millis now) {
  Millis before = 0;
  for (std::size_t i = 0; i < last_->index; ++i) before += programme_.phases[i].duration;
  const Millis longest = std::max<Millis>(0, programme_.phases[last_->index].duration - 1000);
  programme_.cycle_start = now - before - std::clamp<Millis>(now - last_->since, 0, longest);
}

}  // namespace thalweg
