// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "cch/metric.hpp"

namespace thalweg {

/// Costs from every vertex to up to 16 destinations at once: upward from the destinations along the
/// elimination tree, then one pass over all vertices from the highest rank down (PHAST, Delling et al. 2013).
/// One a thread.
template <CchWeight W>
class CchSweep {
 public:
  static constexpr std::size_t width = 16;

  /// At most `width` destinations.
  void run(const CchTopology& topology, const CchMetric<W>& metric, std::span<const VertexId> destinations);

  /// To the i-th destination of the last run, junctions and all roads but the destination's own included.
  [[nodiscard]] W cost(const CchTopology& topology, VertexId from, std::size_t i) const {
    return labels_[topology.rank(from)][i];
  }

 private:
  using Lanes = std::array<W, width>;
  std::vector<Lanes> labels_;  ///< by rank
};

/// Costs to one destination, each found when it is asked for: nothing beside the ancestors of the vertices
/// asked for is touched (lazy RPHAST; Strasser and Zeitz 2021). For destinations that few vehicles share. One
/// a thread.
template <CchWeight W>
class CchLazyCosts {
 public:
  void start(const CchTopology& topology, const CchMetric<W>& metric, VertexId destination);
  W cost(const CchTopology& topology, const CchMetric<W>& metric, VertexId from);

 private:
  std::vector<W> labels_;                   ///< by rank; infinite but at `touched_`
  std::vector<std::uint8_t> is_final_;      ///< by rank; only at `touched_`
  std::vector<CchTopology::Rank> touched_;  ///< what the next start wipes
  std::vector<CchTopology::Rank> chain_;    ///< scratch
};

extern template class CchSweep<std::uint32_t>;
extern template class CchSweep<std::uint64_t>;
extern template class CchLazyCosts<std::uint32_t>;
extern template class CchLazyCosts<std::uint64_t>;

}  // namespace thalweg
