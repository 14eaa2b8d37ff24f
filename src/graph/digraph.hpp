// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/id.hpp"

namespace thalweg {

/// One end of an arc as its other end sees it.
struct Arc {
  VertexId end;  ///< the head in `out`, the tail in `in`
  ArcId id;      ///< indexes the costs
};

struct ArcEnds {
  VertexId tail;
  VertexId head;
  auto operator<=>(const ArcEnds&) const = default;
};

/// Which way a search walks: from its source along the arcs, or from its destination against them.
enum class Direction : std::uint8_t { forward, backward };

/// An immutable directed graph in compressed rows, forward and backward. Loops and parallel arcs may occur.
/// ArcId i is the i-th arc given to the constructor; arcs of a vertex keep that order.
class Digraph {
 public:
  Digraph() = default;
  /// Every end must be below `vertices`.
  Digraph(std::size_t vertices, std::span<const ArcEnds> arcs);

  [[nodiscard]] std::size_t vertex_count() const { return out_first_.empty() ? 0 : out_first_.size() - 1; }
  [[nodiscard]] std::size_t arc_count() const { return ends_.size(); }
  [[nodiscard]] const ArcEnds& ends(ArcId arc) const { return ends_[arc.value]; }

  [[nodiscard]] std::span<const Arc> out(VertexId v) const { return row(out_first_, out_, v); }
  [[nodiscard]] std::span<const Arc> in(VertexId v) const { return row(in_first_, in_, v); }
  /// The arcs that a search in this direction leaves `v` by.
  template <Direction direction>
  [[nodiscard]] std::span<const Arc> leaving(VertexId v) const {
    if constexpr (direction == Direction::forward) return out(v);
    return in(v);
  }
  /// The arcs that a search in this direction reaches `v` by.
  template <Direction direction>
  [[nodiscard]] std::span<const Arc> reaching(VertexId v) const {
    if constexpr (direction == Direction::forward) return in(v);
    return out(v);
  }

 private:
  [[nodiscard]] static std::span<const Arc> row(const std::vector<std::uint32_t>& first,
                                                const std::vector<Arc>& arcs, VertexId v) {
    return {arcs.data() + first[v.value], arcs.data() + first[v.value + 1]};
  }

  std::vector<ArcEnds> ends_;
  std::vector<std::uint32_t> out_first_;
  std::vector<std::uint32_t> in_first_;
  std::vector<Arc> out_;
  std::vector<Arc> in_;
};

}  // namespace thalweg
