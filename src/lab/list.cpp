// SPDX-License-Identifier: Apache-2.0
#include "lab/list.hpp"

namespace thalweg::lab {

std::span<const Experiment> experiments() {
  static const std::vector<Experiment> list{
      runtime_experiment(),
      enumerate_experiment(),
  };
  return list;
}

}  // namespace thalweg::lab
