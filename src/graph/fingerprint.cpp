// SPDX-License-Identifier: Apache-2.0
#include "graph/fingerprint.hpp"

namespace thalweg {

std::uint64_t fingerprint(const Digraph& graph) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  const auto add =
      [&](std::uint64_t word) {  // the multiplier of Knuth's and a shift: every bit of both moves
        hash = (hash ^ word) * 0x9e3779b97f4a7c15ULL;
        hash ^= hash >> 29U;
      };
  add(graph.vertex_count());
  for (std::size_t i = 0; i < graph.arc_count(); ++i) {
    const auto [tail, head] = graph.ends(ArcId{i});
    add(static_cast<std::uint64_t>(tail.value) << 32U | head.value);
  }
  return hash;
}

}  // namespace thalweg
