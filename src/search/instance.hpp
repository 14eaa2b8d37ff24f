// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/id.hpp"
#include "graph/digraph.hpp"

namespace thalweg {

/// The paper's types of instance. The reverse of (u, v) is any (v, u); a loop is its own.
enum class InstanceType : std::uint8_t {
  mixed,    ///< some arcs have a reverse, some have none
  simple,   ///< every arc has its reverse; also a graph without arcs
  directed  ///< no arc has its reverse
};

[[nodiscard]] InstanceType instance_type(const Digraph& graph);

struct Components {
  IdVector<VertexId, std::uint32_t> number;  ///< component of each vertex, 0 .. count - 1
  std::uint32_t count = 0;
};

/// The strongly connected components (Tarjan 1972), in O(V + E). Numbers are in reverse topological order: an
/// arc between two components leads to the lower number.
[[nodiscard]] Components strong_components(const Digraph& graph);

}  // namespace thalweg
