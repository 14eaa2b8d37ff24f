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

/// The mean around each second of the cycle, by a normal distribution.
std::vector<float> smoothed(std::span<const double> values, double deviation) {
  const auto cycle = static_cast<std::ptrdiff_t>(values.size());
  const auto reach = static_cast<std::ptrdiff_t>(std::ceil(3 * deviation));
  std::vector<double> weights;
  for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
    const double x = static_cast<double>(k) / deviation;
    weights.push_back(std::exp(-x * x / 2));
  }
  const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<float> result(values.size());
  for (std::ptrdiff_t second = 0; second < cycle; ++second) {
    double sum = 0;
    for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
      const std::ptrdiff_t at = ((second + k) % cycle + cycle) % cycle;
      sum += weights[static_cast<std::size_t>(k + reach)] * values[static_cast<std::size_t>(at)];
    }
    result[static_cast<std::size_t>(second)] = static_cast<float>(sum / all);
  }
  return result;
}

}  // namespace

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
  for (std::size_t level = 0; level < levels; ++level)
    table.deviation[level] = smoothed(deviations, std::exp2(static_cast<double>(level)));
}

double SignalWaits::deviation(MovementId movement, Millis time, double ahead) const {
  const Table& table = tables_[table_of_[movement]];
  const double level = std::log2(standard_deviation(ahead));
  const auto low = static_cast<std::size_t>(level);
  if (low >= levels) return 0;
  const std::size_t cycle = table.deviation[low].size();
  const Millis whole = static_cast<Millis>(cycle) * 1000;
  const Millis within = ((time - table.start) % whole + whole) % whole;
  const auto second = static_cast<std::size_t>(within / 1000);
  const auto after = second + 1 < cycle ? second + 1 : 0;
  const double part = static_cast<double>(within % 1000) / 1000;
  const auto at = [&](std::size_t l) {
    return static_cast<double>(table.deviation[l][second]) * (1 - part) +
           static_cast<double>(table.deviation[l][after]) * part;
  };
  const double high = low + 1 < levels ? at(low + 1) : 0;
  const double share = level - static_cast<double>(low);
  return at(low) * (1 - share) + high * share;
}

}  // namespace thalweg
