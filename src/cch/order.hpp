// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "graph/digraph.hpp"

namespace thalweg {

/// An order of elimination: order[rank] is the vertex of that rank; low ranks are eliminated first.
using EliminationOrder = std::vector<VertexId>;

/// By nested dissection of the graph without directions (METIS, Karypis and Kumar 1998): small separators
/// come last, so that eliminating the vertices adds few edges. Postordered, deterministic. InputError: METIS
/// gives up.
EliminationOrder nested_dissection(const Digraph& graph);

/// The order that adds the same edges and numbers every subtree of the elimination tree without gaps, so that
/// what is used together lies together (an equivalent reordering; Liu 1990).
EliminationOrder postordered(const Digraph& graph, const EliminationOrder& order);

}  // namespace thalweg
