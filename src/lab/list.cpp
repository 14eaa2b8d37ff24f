// SPDX-License-Identifier: Apache-2.0
#include "lab/list.hpp"

namespace thalweg::lab {

std::span<const Experiment> experiments() {
  static const std::vector<Experiment> list{
      runtime_experiment(),       enumerate_experiment(),    polygon_experiment(),
      triangle_experiment(),      greedy_experiment(),       dynamic_experiment(),
      density_experiment(),       regular_experiment(),      evolve_experiment(),
      evolve_rounds_experiment(), city_regions_experiment(), city_dynamic_experiment(),
      live_score_experiment(),    crew_experiment(),         memory_experiment(),
  };
  return list;
}

}  // namespace thalweg::lab
