// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <limits>
#include <vector>

#include "cch/topology.hpp"
#include "core/time.hpp"

namespace thalweg {

/// What costs are counted in within the hierarchy: 32 bits where no path can overflow them (twice as fast),
/// else 64.
template <class W>
concept CchWeight = std::same_as<W, std::uint32_t> || std::same_as<W, std::uint64_t>;

/// No way. The sum of two of these does not wrap; whatever is above counts as it. That of 64 bits is
/// `infinity` or more, so that sums of Millis saturate alike.
template <CchWeight W>
inline constexpr W cch_infinity = std::numeric_limits<W>::max() / 2;

/// A label as a cost.
template <CchWeight W>
constexpr Millis from_label(W label) {
  return label >= std::min<std::uint64_t>(cch_infinity<W>, infinity) ? infinity : static_cast<Millis>(label);
}

/// The costs of every edge of the completion, customised from turn costs: after that the costs upward and
/// downward are shortest among all ways over lower ranks. Replaced as a whole each round; storage is kept.
template <CchWeight W>
class CchMetric {
 public:
  /// `costs` by ArcId in ms, >= 0; infinity or more: closed. The result does not depend on `threads`.
  void customise(const CchTopology& topology, const std::vector<Millis>& costs, std::size_t threads = 1);

  std::vector<W> up;    ///< by edge: from its lower end to its higher
  std::vector<W> down;  ///< by edge: from its higher end to its lower

  /// An edge as a way runs along it.
  struct Step {
    CchTopology::Rank lower;  ///< end of the edge
    CchTopology::EdgeIndex edge;
    bool upward;
  };
  /// What a step costs as much as: an arc of the graph, the way over a lower vertex (its rank), or several of
  /// these. Its cost is below infinity; `graph` and `costs` are what the metric was customised for. Found
  /// when it is first asked for, kept until the next customisation; safe to be asked by many threads.
  using Over = CchTopology::Rank;
  static constexpr Over an_arc = std::numeric_limits<Over>::max();
  static constexpr Over several = an_arc - 1;
  [[nodiscard]] Over over(const Digraph& graph, const std::vector<Millis>& costs, const CchTopology& topology,
                          const Step& step) const;

 private:
  using Slots = std::vector<CchTopology::EdgeIndex>;

  void take_costs(const CchTopology& topology, const std::vector<Millis>& costs, CchTopology::Rank first,
                  CchTopology::Rank last);
  [[nodiscard]] Over find_over(const Digraph& graph, const std::vector<Millis>& costs,
                               const CchTopology& topology, const Step& step) const;
  void relax_row(const CchTopology& topology, CchTopology::Rank x, Slots& slots);

  static constexpr Over unknown = several - 1;
  mutable std::vector<Over> over_;  ///< by edge, downward and upward; read and written as atomics
  std::vector<Slots>
      slots_;  ///< scratch, one a thread: by rank, the edge that leads there from the row's vertex
};

extern template class CchMetric<std::uint32_t>;
extern template class CchMetric<std::uint64_t>;

}  // namespace thalweg
