// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "cch/lone_search.hpp"
#include "cch/order_cache.hpp"

namespace thalweg {

/// The least time that is left to a destination: what guides a search by the time of entry. Near what each
/// turn takes at the best time, so that such a search looks at little beside the way that it finds
/// (CCH-potentials: Strasser, Zeitz, "A Fast and Tight Heuristic for A* in Road Networks", 2021). Signals
/// have two best times: with what they show as long as that is known, in the mean of their cycles afterwards.
/// Knowing what they show is taken to save at most a fifth of the time for which that is known. This is no
/// strict bound: a way that saves more may be missed (docs/tried.md).
class Potentials {
 public:
  /// Of one destination; one a thread.
  struct Search {
    CchLoneSearch<std::uint32_t> in_mean;
    CchLoneSearch<std::uint32_t> best;
    VertexId destination{};
    bool has_best = false;  ///< many searches need nothing of it
  };

  Potentials(const Digraph& turns, const OrderCache& cache);

  /// By ArcId in ms, infinity: closed; `in_mean` is nowhere below `best`. The result does not depend on
  /// `threads`.
  void refresh(const std::vector<Millis>& best, const std::vector<Millis>& in_mean, std::size_t threads);

  void start(Search& search, VertexId destination) const {
    search.in_mean.start(topology_, in_mean_, destination);
    search.destination = destination;
    search.has_best = false;
  }
  /// In ms from entering `from`, by one who knows what signals show for `known` ms from then on; infinity
  /// where there is no way, or none of less than 24 days. What is above `most` is only known to be.
  [[nodiscard]] Millis left(Search& search, VertexId from, Millis known, Millis most) const {
    const Millis in_mean = from_label(search.in_mean.cost(topology_, in_mean_, from));
    if (!has_luck_ || known <= 0 || in_mean >= infinity) return in_mean;
    const Millis with_luck = in_mean - known / 5;
    if (with_luck > most) return with_luck;
    if (!search.has_best) search.best.start(topology_, best_, search.destination);
    search.has_best = true;
    return std::max(with_luck, from_label(search.best.cost(topology_, best_, from)));
  }

 private:
  CchTopology topology_;
  CchMetric<std::uint32_t> best_;  // sums saturate
  CchMetric<std::uint32_t> in_mean_;
  bool has_luck_ = false;  ///< the two differ; else the first is not made
};

}  // namespace thalweg
