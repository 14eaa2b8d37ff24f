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

extern template class CchSweep<std::uint32_t>;
extern template class CchSweep<std::uint64_t>;

}  // namespace thalweg
