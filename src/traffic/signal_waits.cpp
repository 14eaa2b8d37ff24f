// SPDX-License-Identifier: Apache-2.0
#include "traffic/signal_waits.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace thalweg {
namespace {

/// Of the time at a stop line: 2 s are the difference between drivers, a twentieth of the time until then is
/// what travel times are uncertain by. Three other pairs were tried on five generated cities (docs/tried.md).
double standard_deviation(double ahead) { return 2 + 0.05 * std::max(0.0, ahead); }

constexpr double fading = 60;  ///< s before SignalWaits::known_ahead in which what is known does

/// The mean around each second of the cycle, by a normal distribution.
std::vector<float> smoothed(std::span<const double> values, double deviation) {
  const std::size_t cycle = values.size();
  const auto reach = static_cast<std::size_t>(std::ceil(3 * deviation));
  std::vector<float> weights(2 * reach + 1);
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const double x = (static_cast<double>(k) - static_cast<double>(reach)) / deviation;
    weights[k] = static_cast<float>(std::exp(-x * x / 2));
  }
  const float all = std::accumulate(weights.begin(), weights.end(), 0.0F);
  std::vector<float> around(cycle + 2 * reach);  // the cycle, and what comes before and after it
  const std::size_t before = cycle - reach % cycle;
  for (std::size_t i = 0; i < around.size(); ++i)
    around[i] = static_cast<float>(values[(before + i) % cycle]);
  std::vector<float> result(cycle, 0.0F);
  for (std::size_t k = 0; k < weights.size(); ++k) {
    for (std::size_t i = 0; i < cycle; ++i) result[i] += weights[k] * around[i + k];
  }
  for (float& value : result) value /= all;
  return result;
}

}  // namespace

SignalWaits::SignalWaits(std::size_t movements) : table_of_(movements, none) {
  level_by_second_.resize(known_ahead / 1000);
  for (std::size_t second = 0; second < level_by_second_.size(); ++second)
    level_by_second_[second] = std::log2(standard_deviation(static_cast<double>(second)));
}

void SignalWaits::set(MovementId movement, std::span<const std::size_t> until_open, Millis start) {
  std::vector<double> deviations(until_open.begin(), until_open.end());
  const double mean = std::accumulate(deviations.begin(), deviations.end(), 0.0) /
                      std::max<double>(1, static_cast<double>(deviations.size()));
  const bool ever_opens = std::find(until_open.begin(), until_open.end(), std::size_t{0}) != until_open.end();
  if (!ever_opens || mean <= 0) return clear(movement);
  for (double& value : deviations) value -= mean;
  if (table_of_[movement] == none) {
    table_of_[movement] = static_cast<std::uint32_t>(tables_.size());
    tables_.emplace_back();
  }
  Table& table = tables_[table_of_[movement]];
  table.start = start;
  table.mean = mean;
  table.deviation.resize(deviations.size());
  for (std::size_t level = 0; level < levels; ++level) {
    const auto around = smoothed(deviations, std::exp2(static_cast<double>(level)));
    for (std::size_t second = 0; second < around.size(); ++second)
      table.deviation[second][level] = around[second];
  }
}

double SignalWaits::deviation(MovementId movement, Millis time, double ahead) const {
  const Table& table = tables_[table_of_[movement]];
  const auto whole_seconds = static_cast<std::size_t>(std::max(0.0, ahead));
  if (whole_seconds >= level_by_second_.size()) return 0;
  const double level = level_by_second_[whole_seconds];
  const auto low = static_cast<std::size_t>(level);
  const std::size_t cycle = table.deviation.size();
  const Millis whole = static_cast<Millis>(cycle) * 1000;
  const Millis rest = (time - table.start) % whole;
  const Millis within = rest < 0 ? rest + whole : rest;
  const auto second = static_cast<std::size_t>(within / 1000);
  const std::size_t after = second + 1 < cycle ? second + 1 : 0;
  const double part = static_cast<double>(within % 1000) / 1000;
  const auto at = [&](std::size_t l) {
    return static_cast<double>(table.deviation[second][l]) * (1 - part) +
           static_cast<double>(table.deviation[after][l]) * part;
  };
  const double share = level - static_cast<double>(low);
  const double known = std::min(1.0, (to_seconds(known_ahead) - ahead) / fading);
  return known * (at(low) * (1 - share) + at(low + 1) * share);
}

}  // namespace thalweg
