// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "xml/node.hpp"

namespace thalweg {

/// The trips (or vehicles, when it brings its route) of a <flow>, as SUMO numbers and times them: "id.0",
/// "id.1" .. from `begin` on, a `period` apart, or `number` of them evenly until `end`. InputError: it has no
/// end, or its times are drawn at random (`probability`, `poisson`, `exp(..)`), which is duarouter's to do.
std::vector<xml::Node> expand_flow(const xml::Node& flow);

}  // namespace thalweg
