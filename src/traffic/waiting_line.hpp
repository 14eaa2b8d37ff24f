// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace thalweg {

/// A line of those who want to get on a road, in the order of their departures, as a forecast moves it. Those
/// who got in stay known. Times in s from the forecast on.
class WaitingLine {
 public:
  struct Vehicle {
    std::uint32_t mover;  ///< who, by the forecast's numbers
    float wanted;         ///< its departure; the past for one that waits already
    float entered;        ///< when it gets in; infinity: not yet known
  };

  [[nodiscard]] std::span<const Vehicle> vehicles() const { return vehicles_; }
  /// Those who still wait.
  [[nodiscard]] std::span<const Vehicle> waiting() const { return vehicles().subspan(head_); }
  /// When the first may get in, where there is room.
  [[nodiscard]] double free_at() const { return free_at_; }

  void clear();  // keeps the storage
  void join(std::uint32_t mover, float wanted);
  void let_in_first(double time, double headway);
  /// When one would that had wanted to depart at this time, once everybody is let in.
  [[nodiscard]] double when(double wanted, double headway) const;

 private:
  static constexpr double long_ago = -1e9;

  std::vector<Vehicle> vehicles_;
  std::size_t head_ = 0;  ///< the first that still waits
  double free_at_ = long_ago;
};

}  // namespace thalweg
