// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "graph/road_graph.hpp"

namespace thalweg {

/// Travel times from a weight file of SUMO's (`<interval><edge id traveltime/>`, as edgeData and duarouter
/// have them): those of the interval that holds `time` replace the free-flow times, and are never below them.
/// InputError: an edge that the net has not, a time that is negative or no number, no interval at `time`.
void apply_weight_file(const std::filesystem::path& file, const Network& network, Millis time,
                       RoadTimes& times);

}  // namespace thalweg
