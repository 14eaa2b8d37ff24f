// SPDX-License-Identifier: Apache-2.0
#include "graph/digraph.hpp"

namespace thalweg {
namespace {

/// Counting sort of the arcs by the end that `key` picks; `other` is what the row shows.
void build_rows(std::size_t vertices, std::span<const ArcEnds> ends, VertexId ArcEnds::*key,
                VertexId ArcEnds::*other, std::vector<std::uint32_t>& first, std::vector<Arc>& rows) {
  first.assign(vertices + 1, 0);
  for (const ArcEnds& arc : ends) ++first[(arc.*key).value + 1];
  for (std::size_t v = 0; v < vertices; ++v) first[v + 1] += first[v];
  rows.resize(ends.size());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    rows[next[(ends[i].*key).value]++] = Arc{.end = ends[i].*other, .id = ArcId{i}};
  }
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
