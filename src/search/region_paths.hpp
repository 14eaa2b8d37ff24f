// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graph/digraph.hpp"
#include "search/big_count.hpp"
#include "search/path_range.hpp"
#include "search/regions.hpp"

namespace thalweg {

/// The paper's EBOGP: every fewest-arc path from the sources of a partition to `target`, one at a time. Walks
/// from the target against the arcs, each step into the fore region, so that no step is in vain: the work for
/// a path is at most its length. Parallel arcs make different paths. Of a target in region 1 there is one
/// path, without arcs; of one in no region there is none.
///
///     for (std::span<const ArcId> arcs : RegionPaths(graph, regions, target)) ...
///
/// `regions` must be `partition<Direction::forward>` of `graph`; both must outlive the range.
class RegionPaths : public PathRange<RegionPaths> {
 public:
  RegionPaths(const Digraph& graph, const Regions& regions, VertexId target);

  /// To the next path; false: there is none. `begin` calls it.
  bool advance();
  [[nodiscard]] std::span<const ArcId> path() const { return path_; }
  /// Vertices entered so far, the target included (the paper's loops: C(2k, k) - 1 on the k x k grid).
  [[nodiscard]] std::uint64_t visits() const { return visits_; }

 private:
  const Digraph& graph_;
  const Regions& regions_;
  std::vector<std::span<const Arc>> untried_;  ///< arcs into each vertex from the target on, not tried yet
  std::vector<ArcId> path_;
  std::uint64_t visits_ = 0;
  bool at_source_ = false;  ///< the target is a source, and its path was not seen yet
};

/// How many fewest-arc paths lead from the sources of `regions` to `target`, without walking them: a sum over
/// the regions, in O(E) additions. C(2k - 2, k - 1) from corner to corner of the k x k grid.
[[nodiscard]] BigCount count_region_paths(const Digraph& graph, const Regions& regions, VertexId target);

}  // namespace thalweg
