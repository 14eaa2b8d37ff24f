// SPDX-License-Identifier: Apache-2.0
#include "routing/potentials.hpp"

#include "graph/fingerprint.hpp"

namespace thalweg {

Potentials::Potentials(const Digraph& turns, const OrderCache& cache)
    : topology_(turns, cached_dissection(turns, fingerprint(turns), cache)) {}

void Potentials::refresh(const std::vector<Millis>& least, std::size_t threads) {
  metric_.customise(topology_, least, threads);
}

}  // namespace thalweg
