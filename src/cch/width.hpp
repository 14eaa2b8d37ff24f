// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cch/metric.hpp"

namespace thalweg {

/// No simple path costs as much as 32 bits hold: it leaves each vertex at most once. Quick, and enough for a
/// city on free flow.
bool fits_32_bits(const Digraph& graph, const std::vector<Millis>& costs);

/// The same for shortest paths only, seen in the narrow metric of these costs. One from s to t is no longer
/// than by way of the highest vertex, where s leads there and that leads to t; where not, it stays among the
/// vertices that do not lead there (or are not led to), and leaves each of them at most once.
bool fits_32_bits(const Digraph& graph, const std::vector<Millis>& costs, const CchTopology& topology,
                  const CchMetric<std::uint32_t>& metric);

}  // namespace thalweg
