// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace thalweg {

/// Seeded random numbers, the same on every platform (the standard's distributions are not) and without bias.
/// A stream belongs to (seed, stream): repetitions take their number for the stream, so that it does not
/// matter which thread runs which.
class Dice {
 public:
  explicit Dice(std::uint64_t seed, std::uint64_t stream = 0) : state_(mixed(mixed(seed) + stream)) {}

  /// SplitMix64 (Steele, Lea and Flood 2014).
  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15ULL;
    return mixed(state_);
  }
  /// 0 .. sides - 1, sides > 0, each equally likely (numbers of an incomplete last round are thrown away).
  std::uint64_t roll(std::uint64_t sides) {
    const std::uint64_t incomplete = (0 - sides) % sides;
    while (true) {
      const std::uint64_t number = next();
      if (number >= incomplete) return number % sides;
    }
  }
  /// In [0, 1).
  double unit() { return static_cast<double>(next() >> 11U) * 0x1p-53; }
  template <class T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[roll(i)]);
  }
  template <class T>
  const T& pick(const std::vector<T>& items) {
    return items[roll(items.size())];
  }

 private:
  static constexpr std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31U);
  }
  std::uint64_t state_;
};

}  // namespace thalweg
