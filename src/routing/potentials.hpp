// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cch/lone_search.hpp"
#include "cch/order_cache.hpp"

namespace thalweg {

/// The least time that is left to a destination, whenever one drives: what guides a search by the time of
/// entry. Exact for the least that each turn takes, so that such a search looks at little beside the way that
/// it finds (CCH-potentials: Strasser, Zeitz, "A Fast and Tight Heuristic for A* in Road Networks", 2021).
class Potentials {
 public:
  /// Of one destination; one a thread.
  using Search = CchLoneSearch<std::uint32_t>;

  Potentials(const Digraph& turns, const OrderCache& cache);

  /// `least` by ArcId in ms; infinity: closed. The result does not depend on `threads`.
  void refresh(const std::vector<Millis>& least, std::size_t threads);

  void start(Search& search, VertexId destination) const { search.start(topology_, metric_, destination); }
  /// In ms from entering `from`; infinity where there is no way, or none of less than 24 days.
  [[nodiscard]] Millis left(Search& search, VertexId from) const {
    return from_label(search.cost(topology_, metric_, from));
  }

 private:
  CchTopology topology_;
  CchMetric<std::uint32_t> metric_;  // its sums saturate
};

}  // namespace thalweg
