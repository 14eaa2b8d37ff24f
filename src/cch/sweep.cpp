// SPDX-License-Identifier: Apache-2.0
#include "cch/sweep.hpp"

#include <algorithm>
#include <cstring>

// The loop over the vertices is compiled once for each of these; the loader picks the best at start.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define THALWEG_CLONES __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define THALWEG_CLONES
#endif

namespace thalweg {
namespace {

using Rank = CchTopology::Rank;

/// labels[v][i] = min over the edges v -> head of up + labels[head][i], for every vertex from the highest
/// down. Labels lie lane by lane, 16 a vertex.
/// Written with the compiler's vectors: from plain loops GCC 12 vectorises over the edges instead.
template <class W>
[[gnu::always_inline]] inline void sweep_lanes(const std::uint32_t* first, const Rank* heads, const W* up,
                                               W* labels, std::size_t vertices) {
  typedef W Lanes __attribute__((vector_size(16 * sizeof(W))));  // NOLINT(modernize-use-using)
  for (std::size_t v = vertices; v-- > 0;) {
    Lanes best;
    std::memcpy(&best, labels + v * 16, sizeof best);
    for (std::uint32_t edge = first[v]; edge < first[v + 1]; ++edge) {
      Lanes other;
      std::memcpy(&other, labels + static_cast<std::size_t>(heads[edge]) * 16, sizeof other);
      const Lanes sum = other + up[edge];
      best = sum < best ? sum : best;
    }
    std::memcpy(labels + v * 16, &best, sizeof best);
  }
}

// One of each width, since a template cannot have clones.
THALWEG_CLONES void sweep_down(const std::uint32_t* first, const Rank* heads, const std::uint32_t* up,
                               std::uint32_t* labels, std::size_t vertices) {
  sweep_lanes(first, heads, up, labels, vertices);
}
THALWEG_CLONES void sweep_down(const std::uint32_t* first, const Rank* heads, const std::uint64_t* up,
                               std::uint64_t* labels, std::size_t vertices) {
  sweep_lanes(first, heads, up, labels, vertices);
}

}  // namespace

template <CchWeight W>
void CchSweep<W>::run(const CchTopology& topology, const CchMetric<W>& metric,
                      std::span<const VertexId> destinations) {
  assert(destinations.size() <= width);
  Lanes none;
  none.fill(cch_infinity<W>);
  labels_.assign(topology.vertex_count(), none);
  for (std::size_t i = 0; i < destinations.size(); ++i) {
    Rank v = topology.rank(destinations[i]);
    labels_[v][i] = 0;
    while (true) {  // up the elimination tree: the ways into the destination
      const W label = labels_[v][i];
      for (auto edge = topology.first_edge(v); edge < topology.first_edge(v + 1); ++edge) {
        W& higher = labels_[topology.head(edge)][i];
        higher = std::min<W>(higher, label + metric.down[edge]);
      }
      if (topology.parent(v) == v) break;
      v = topology.parent(v);
    }
  }
  if (topology.vertex_count() == 0) return;
  sweep_down(topology.first_edges(), topology.all_heads(), metric.up.data(), labels_.front().data(),
             topology.vertex_count());
}

template class CchSweep<std::uint32_t>;
template class CchSweep<std::uint64_t>;

}  // namespace thalweg
