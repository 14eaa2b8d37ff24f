// SPDX-License-Identifier: Apache-2.0
#include "graph/digraph.hpp"

#include "core/rows.hpp"

namespace thalweg {
namespace {

/// Rows of arcs by the end that `key` picks; `other` is what the row shows.
void build_rows(std::size_t vertices, std::span<const ArcEnds> ends, VertexId ArcEnds::*key,
                VertexId ArcEnds::*other, std::vector<std::uint32_t>& first, std::vector<Arc>& rows) {
  const auto for_each = [&](const auto& visit) {
    for (std::size_t i = 0; i < ends.size(); ++i)
      visit((ends[i].*key).value, [&] { return Arc{.end = ends[i].*other, .id = ArcId{i}}; });
  };
  fill_rows(vertices, for_each, first, rows);
}

}  // namespace

Digraph::Digraph(std::size_t vertices, std::span<const ArcEnds> arcs) : ends_(arcs.begin(), arcs.end()) {
  for ([[maybe_unused]] const ArcEnds& arc : ends_) {
    assert(arc.tail.value < vertices && arc.head.value < vertices);
  }
  build_rows(vertices, ends_, &ArcEnds::tail, &ArcEnds::head, out_first_, out_);
  build_rows(vertices, ends_, &ArcEnds::head, &ArcEnds::tail, in_first_, in_);
}

}  // namespace thalweg
