// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "report/comparison.hpp"

namespace thalweg {

/// What `thalweg compare` prints: UTF-8, no colours, a few short tables and then the warnings. The first line
/// names SUMO's version, the seeds and the configuration. Every line ends with a newline.
std::string format_table(const Comparison& comparison);

}  // namespace thalweg
