// SPDX-License-Identifier: Apache-2.0
#include "routing/potentials.hpp"

#include "graph/fingerprint.hpp"

namespace thalweg {

Potentials::Potentials(const Digraph& turns, const OrderCache& cache)
    : topology_(turns, cached_dissection(turns, fingerprint(turns), cache)) {}

void Potentials::refresh(const std::vector<Millis>& best, const std::vector<Millis>& in_mean,
                         std::size_t threads) {
  has_luck_ = best != in_mean;
  if (has_luck_) best_.customise(topology_, best, threads);
  in_mean_.customise(topology_, in_mean, threads);
}

}  // namespace thalweg
