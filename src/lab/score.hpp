// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/time.hpp"
#include "graph/digraph.hpp"
#include "search/evolve.hpp"
#include "search/hybrid.hpp"

namespace thalweg::lab {

/// What can be read off a system's weights at any moment. The paper's eta is |Y| / |w|: weights dealt from
/// 1 .. |Y| into an array w. Of a system that is met as it is, |Y| is the greatest weight and w the weights
/// that occur: as a set (each once) in `eta`, as many as there are arcs in `eta_of_arcs`.
struct Scores {
  std::uint64_t different = 0;  ///< weights that occur, each once
  double eta = 0;
  double gap = 0;  ///< (w_max - w_min) / |w|, the paper's other form, w a set
  double eta_of_arcs = 0;
  double variation =
      0;  ///< standard deviation / mean: no score of the paper's, what a statistician would try
};

/// Of the weights that are below infinity, all above 0. Zeros when there are none.
[[nodiscard]] Scores scores_of(std::span<const Millis> weights);

/// How far hybrid is from the optimum, from one source to all that it reaches.
struct Accuracy {
  std::uint64_t pairs = 0;
  double optimal = 0;  ///< targets whose fewest-arc path is the best one, in %
  double excess = 0;   ///< of hybrid over the optimum, mean, in %
};

struct AccuracyScratch {
  Regions regions;
  Tree hybrid;
  Tree exact;
  EvolveScratch evolve;
};

/// `costs` by arc, all above 0.
[[nodiscard]] Accuracy accuracy_from(const Digraph& graph, std::span<const Millis> costs, VertexId source,
                                     AccuracyScratch& scratch);

/// Spearman's rank correlation (equal values share the mean of their ranks); nullopt with fewer than three
/// pairs, or when one side does not vary.
[[nodiscard]] std::optional<double> rank_correlation(std::span<const double> a, std::span<const double> b);

}  // namespace thalweg::lab
