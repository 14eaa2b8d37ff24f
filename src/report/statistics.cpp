// SPDX-License-Identifier: Apache-2.0
#include "report/statistics.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cassert>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

namespace thalweg {
namespace {

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Of the sample: divided by n - 1.
double variance_of(std::span<const double> values) {
  const double mean = mean_of(values);
  double sum = 0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return sum / static_cast<double>(values.size() - 1);
}

/// Student's t that leaves 2.5 % on either side.
double t_quantile(double degrees_of_freedom) {
  return boost::math::quantile(boost::math::students_t(degrees_of_freedom), 0.975);
}

double half_width_of(double variance, std::size_t count) {
  const auto n = static_cast<double>(count);
  return t_quantile(n - 1) * std::sqrt(variance / n);
}

}  // namespace

std::optional<double> Estimate::low() const {
  if (!half_width) return std::nullopt;
  return mean - *half_width;
}

std::optional<double> Estimate::high() const {
  if (!half_width) return std::nullopt;
  return mean + *half_width;
}

bool Estimate::differs_from_zero() const { return half_width && std::abs(mean) > *half_width; }

Estimate estimate(std::span<const double> values) {
  Estimate result;
  result.count = values.size();
  if (!values.empty()) result.mean = mean_of(values);
  if (values.size() > 1) result.half_width = half_width_of(variance_of(values), values.size());
  return result;
}

Estimate paired_difference(std::span<const double> a, std::span<const double> b) {
  assert(a.size() == b.size());
  std::vector<double> differences(a.size());
  std::transform(a.begin(), a.end(), b.begin(), differences.begin(), std::minus<>{});
  return estimate(differences);
}

Estimate welch_difference(std::span<const double> a, std::span<const double> b) {
  Estimate result;
  result.count = std::min(a.size(), b.size());
  if (result.count == 0) return result;
  result.mean = mean_of(a) - mean_of(b);
  if (result.count < 2) return result;
  const auto size_a = static_cast<double>(a.size());
  const auto size_b = static_cast<double>(b.size());
  const double part_a = variance_of(a) / size_a;
  const double part_b = variance_of(b) / size_b;
  const double sum = part_a + part_b;
  if (sum == 0) {
    result.half_width = 0;
    return result;
  }
  const double degrees_of_freedom =
      sum * sum / (part_a * part_a / (size_a - 1) + part_b * part_b / (size_b - 1));
  result.half_width = t_quantile(degrees_of_freedom) * std::sqrt(sum);
  return result;
}

std::optional<double> correlation(std::span<const double> a, std::span<const double> b) {
  assert(a.size() == b.size());
  if (a.size() < 3) return std::nullopt;
  const double mean_a = mean_of(a);
  const double mean_b = mean_of(b);
  double aa = 0;
  double bb = 0;
  double ab = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    aa += (a[i] - mean_a) * (a[i] - mean_a);
    bb += (b[i] - mean_b) * (b[i] - mean_b);
    ab += (a[i] - mean_a) * (b[i] - mean_b);
  }
  if (aa == 0 || bb == 0) return std::nullopt;
  return std::clamp(ab / std::sqrt(aa * bb), -1.0, 1.0);
}

std::optional<std::size_t> more_values_needed(std::span<const double> values, double half_width) {
  constexpr std::size_t most = 1'000'000;
  if (values.size() < 2 || !(half_width > 0)) return std::nullopt;
  const double variance = variance_of(values);
  const auto enough = [&](std::size_t count) { return half_width_of(variance, count) <= half_width; };
  if (enough(values.size())) return 0;
  std::size_t too_few = values.size();
  std::size_t count = 2 * too_few;
  while (!enough(count)) {
    if (count > most) return std::nullopt;
    too_few = count;
    count *= 2;
  }
  while (count - too_few > 1) {  // the width falls with the count: halve the gap
    const std::size_t middle = too_few + (count - too_few) / 2;
    (enough(middle) ? count : too_few) = middle;
  }
  return count - values.size();
}

}  // namespace thalweg
