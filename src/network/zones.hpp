// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "network/network.hpp"

namespace thalweg {

/// The names of the two roads that stand for a zone: SUMO's, which trips may also name as any other road.
std::string zone_source(std::string_view zone);
std::string zone_sink(std::string_view zone);

/// Adds the zones (`<taz>`) of an additional file and those it includes to the network, as SUMO's routers do:
/// a zone is a road of no length, its source, that leads to each road where trips may begin, and another one,
/// its sink, to which each road leads where they may end. The least cost from source to sink is that of the
/// best pair of roads; the weights of a zone's roads are for programs that draw (od2trips) and say nothing
/// here. InputError: a zone twice, or one that names an edge which the net has not.
void add_zones(const std::filesystem::path& additional_file, Network& network);

}  // namespace thalweg
