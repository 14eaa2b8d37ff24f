// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "core/id.hpp"
#include "graph/digraph.hpp"

namespace thalweg::lab {

/// The paper's narrow space: a graph whose vertices hold one vehicle at a time, every move takes a step, and
/// two vehicles cannot change places. A vehicle waits outside until its source is free, and is gone when it
/// reaches its target.
struct Errand {
  VertexId source;
  VertexId target;
};

/// What is booked: who stands where at which step, and who moves along which way.
class ReserveTable {
 public:
  [[nodiscard]] bool is_free(VertexId at, std::uint32_t step) const { return !stands_.contains({step, at}); }
  /// A move from `from` to `to` that ends at `step` meets nobody coming the other way.
  [[nodiscard]] bool may_pass(VertexId from, VertexId to, std::uint32_t step) const {
    return !moves_.contains({step, to, from});
  }
  void book_stand(VertexId at, std::uint32_t step) { stands_.insert({step, at}); }
  void book_move(VertexId from, VertexId to, std::uint32_t step) { moves_.insert({step, from, to}); }

 private:
  std::set<std::pair<std::uint32_t, VertexId>> stands_;
  std::set<std::tuple<std::uint32_t, VertexId, VertexId>> moves_;
};

struct CrewOutcome {
  std::vector<std::optional<std::uint32_t>> arrival;  ///< step of each; nullopt: not within the horizon
  [[nodiscard]] std::size_t arrived() const;
};

/// Each in turn books the earliest arrival that the bookings before it leave, waiting and detours included.
[[nodiscard]] CrewOutcome crew_with_table(const Digraph& graph, std::span<const Errand> errands,
                                          std::uint32_t horizon);

/// Each drives its fewest-arc path (hybrid's, with equal weights) and waits while the next vertex is taken.
/// Two that face each other wait for ever: the paper's jam.
[[nodiscard]] CrewOutcome crew_without_table(const Digraph& graph, std::span<const Errand> errands,
                                             std::uint32_t horizon);

}  // namespace thalweg::lab
