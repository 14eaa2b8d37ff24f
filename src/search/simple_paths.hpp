// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "graph/digraph.hpp"
#include "search/big_count.hpp"
#include "search/path_range.hpp"

namespace thalweg {

struct PathLimit {
  std::uint64_t max_paths = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t max_loops = std::numeric_limits<std::uint64_t>::max();
};

/// The paper's BOTS: every simple path from `source` to `target` (no vertex twice), one at a time, depth
/// first in the order of the arcs. Parallel arcs make different paths; from a vertex to itself there is one
/// path, without arcs. The work can grow exponentially: the limit ends it (`cut` then says so).
///
/// `graph` must outlive the range.
class SimplePaths : public PathRange<SimplePaths> {
 public:
  SimplePaths(const Digraph& graph, VertexId source, VertexId target, PathLimit limit = {});

  /// To the next path; false: there is none, or a limit is reached. `begin` calls it.
  bool advance();
  [[nodiscard]] std::span<const ArcId> path() const { return path_; }
  [[nodiscard]] std::uint64_t paths() const { return paths_; }  ///< found so far
  /// Steps so far that led to a vertex other than the target: what the paper counts as loops.
  [[nodiscard]] std::uint64_t loops() const { return loops_; }
  [[nodiscard]] bool cut() const { return cut_; }  ///< ended by a limit, not because all was seen

 private:
  struct Step {
    const Arc* next;
    const Arc* end;
    VertexId vertex;
  };
  void enter(VertexId vertex);

  const Digraph& graph_;
  VertexId target_;
  PathLimit limit_;
  IdVector<VertexId, std::uint8_t> on_path_;
  std::vector<Step> steps_;
  std::vector<ArcId> path_;
  std::uint64_t paths_ = 0;
  std::uint64_t loops_ = 0;
  bool at_target_ = false;
  bool cut_ = false;
};

/// How many simple paths lead from `source` to `target`, without walking them one by one (a frontier method,
/// after Knuth's "simpath", The Art of Computer Programming 4A, 7.1.4, here with directed arcs): the arcs are
/// decided in turn, and what has been decided is remembered only as the ends of the path's pieces among the
/// vertices that still have undecided arcs. The number of such states, not of paths, limits it: nullopt when
/// more than `max_states` would have to be held at once.
[[nodiscard]] std::optional<BigCount> count_simple_paths(const Digraph& graph, VertexId source,
                                                         VertexId target, std::size_t max_states = 2'000'000);

/// How many loops SimplePaths would take: the simple paths that start in `source`, have an arc, and never
/// meet `target`. By `count_simple_paths` of the graph without the target in which every vertex leads to one
/// more.
[[nodiscard]] std::optional<BigCount> count_simple_path_loops(const Digraph& graph, VertexId source,
                                                              VertexId target,
                                                              std::size_t max_states = 2'000'000);

}  // namespace thalweg
