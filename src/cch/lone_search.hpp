// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cch/metric.hpp"

namespace thalweg {

/// Costs and ways to one destination, each found when it is asked for: nothing beside the ancestors of the
/// vertices asked for is touched (lazy RPHAST; Strasser and Zeitz 2021). For destinations that few vehicles
/// share. One a thread.
template <CchWeight W>
class CchLoneSearch {
 public:
  void start(const CchTopology& topology, const CchMetric<W>& metric, VertexId destination);
  W cost(const CchTopology& topology, const CchMetric<W>& metric, VertexId from);

  /// Adds the vertices after `from` to `roads` if one way only costs as little as `cost`, which was asked for
  /// and is below infinity. If there are several: false, and `roads` stays as it was. `graph` and `costs` are
  /// what the metric was customised for.
  ///
  /// A path is a row of edges that rise and then fall, and each edge an arc or two edges over the highest of
  /// the vertices between (Dibbelt, Strasser, Wagner 2016). A path has one such form: so a way is the only
  /// one where exactly one choice at each place is as short as can be.
  [[nodiscard]] bool only_way(const Digraph& graph, const std::vector<Millis>& costs,
                              const CchTopology& topology, const CchMetric<W>& metric, VertexId from,
                              std::vector<VertexId>& roads);

 private:
  using Rank = CchTopology::Rank;
  using EdgeIndex = CchTopology::EdgeIndex;
  using Step = typename CchMetric<W>::Step;
  /// Where the shortest ways from a vertex go first.
  enum class Turn : std::uint8_t { unknown, up, down, either };

  bool collect_steps(const CchTopology& topology, const CchMetric<W>& metric, Rank from);

  Rank destination_ = 0;
  std::vector<W> labels_;                      ///< by rank; infinite but at `touched_`
  std::vector<Turn> turns_;                    ///< by rank; unknown where the label is not final
  std::vector<CchTopology::LowerEdge> falls_;  ///< by rank: the edge down, where that is the way
  std::vector<Rank> touched_;                  ///< what the next start wipes
  std::vector<Rank> chain_;                    ///< scratch
  std::vector<Step> steps_;                    ///< scratch: what is left of a way, the next one last
};

extern template class CchLoneSearch<std::uint32_t>;
extern template class CchLoneSearch<std::uint64_t>;

}  // namespace thalweg
