// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "lab/experiment.hpp"

namespace thalweg::lab {

// One file an experiment. The paper's:
Experiment runtime_experiment();
Experiment enumerate_experiment();
Experiment polygon_experiment();
Experiment triangle_experiment();
Experiment greedy_experiment();
Experiment dynamic_experiment();
Experiment density_experiment();
Experiment regular_experiment();
Experiment evolve_experiment();
// The project's own:
Experiment evolve_rounds_experiment();
Experiment city_regions_experiment();
Experiment city_dynamic_experiment();
Experiment live_score_experiment();
Experiment crew_experiment();
Experiment memory_experiment();

}  // namespace thalweg::lab
