// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace thalweg {

/// The events of a simulation, in the order of their times as far as tenths of a second tell them apart, else
/// in the order in which they were found out: always the same one. A calendar (Brown, Communications of the
/// ACM 1988) and not a heap: cheaper, and what is closer together than that may be in any order. `Event` has
/// a `time` in s.
template <class Event>
class EventCalendar {
 public:
  /// What comes after the horizon, in s, is forgotten.
  explicit EventCalendar(double horizon) : horizon_(horizon), ticks_(tick_of(horizon) + 1) {}

  void clear() {
    nodes_.clear();
    free_ = none;
    ticks_.assign(ticks_.size(), {});
    tick_ = 0;
  }

  /// An event of the present tick, or of an earlier time, comes last in the present one.
  void add(const Event& event) {
    if (event.time > horizon_) return;
    Tick& tick = ticks_[std::max(tick_, tick_of(event.time))];
    std::uint32_t node = free_;
    if (node == none) {
      node = static_cast<std::uint32_t>(nodes_.size());
      nodes_.emplace_back();
    } else {
      free_ = nodes_[node].next;
    }
    nodes_[node] = {.event = event, .next = none};
    (tick.first == none ? tick.first : nodes_[tick.last].next) = node;
    tick.last = node;
  }

  /// One at this time would come in the tick at hand.
  [[nodiscard]] bool is_now(double time) const { return tick_of(time) <= tick_; }

  static constexpr std::size_t foreseen = 4;
  using Foreseen = std::array<const Event*, foreseen>;

  /// Handles all of them, also those that are added meanwhile. Before each, `expect(ahead)` with those that
  /// follow it in this tick and the next ones as far as they are known, the next one first; null: none.
  template <class Expect, class Handle>
  void run(const Expect& expect, const Handle& handle) {
    for (tick_ = 0; tick_ < ticks_.size(); ++tick_) {
      for (std::uint32_t i = ticks_[tick_].first; i != none;) {
        const Event event = nodes_[i].event;
        expect(foresee(i));
        handle(event);
        const std::uint32_t done = std::exchange(i, nodes_[i].next);
        nodes_[done].next = std::exchange(free_, done);
      }
    }
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  static constexpr double ticks_a_second = 10;
  struct Node {
    Event event;
    std::uint32_t next;  ///< in the same tick; of one that is free: the next free one
  };
  struct Tick {
    std::uint32_t first = none;
    std::uint32_t last = none;
  };

  static std::size_t tick_of(double time) {
    return static_cast<std::size_t>(std::max(0.0, time * ticks_a_second));
  }
  [[nodiscard]] Foreseen foresee(std::uint32_t node) const {
    constexpr std::size_t ticks_ahead = 8;
    const std::size_t last = std::min(ticks_.size() - 1, tick_ + ticks_ahead);
    std::size_t tick = tick_;
    Foreseen ahead{};
    for (const Event*& one : ahead) {
      for (node = nodes_[node].next; node == none && tick < last;) node = ticks_[++tick].first;
      if (node == none) break;
      one = &nodes_[node].event;
    }
    return ahead;
  }

  double horizon_;
  std::vector<Node> nodes_;
  std::uint32_t free_ = none;
  std::vector<Tick> ticks_;
  std::size_t tick_ = 0;  ///< at hand
};

}  // namespace thalweg
