// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

#include "network/network.hpp"

namespace thalweg {

/// Reads .net.xml or .net.xml.gz, streamed. InputError names file, line and element of what is wrong: a
/// missing, negative or not finite length or speed, a double id, a road without lanes, a connection to what
/// is not there. A vehicle class that nobody knows is a warning of the network.
Network read_network(const std::filesystem::path& file);

/// The same for a text in memory.
Network parse_network(std::string_view text);

}  // namespace thalweg
