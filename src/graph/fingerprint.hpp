// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "graph/digraph.hpp"

namespace thalweg {

/// A number that belongs to the vertices and arcs as they are numbered; the same on every machine. An address
/// may be used again by another graph, and a file may be meant for another one: this tells them apart.
[[nodiscard]] std::uint64_t fingerprint(const Digraph& graph);

}  // namespace thalweg
