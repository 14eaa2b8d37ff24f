// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/id.hpp"
#include "graph/digraph.hpp"

namespace thalweg::lab {

/// The vertices in a nested-dissection order: each part is cut in two by a level of a breadth-first search
/// from one of its far ends (arcs taken both ways), and the cut comes after both halves (George 1973, with
/// level sets for cuts). A simple stand-in for a real partitioner: the order is valid, the cuts are not
/// small.
[[nodiscard]] std::vector<VertexId> dissection_order(const Digraph& graph);

}  // namespace thalweg::lab
