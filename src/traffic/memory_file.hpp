// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

#include "traffic/memory.hpp"

namespace thalweg {

/// A memory as two files in a folder, in SUMO's own forms, so that its tools read them: `times.xml.gz`, a
/// weight file (`<interval><edge id traveltime/>`, for duarouter's --weight-files), with observations and
/// days as further attributes; and `routes.rou.xml.gz`, the vehicles of the day whose ways are kept, with
/// the routes on which they set out.
void write_memory(const std::filesystem::path& folder, const Network& network, const Memory& memory,
                  std::string_view header);

/// InputError: a file that is missing, cut short or no memory; a road that the net has not; a time or number
/// that cannot be.
Memory read_memory(const std::filesystem::path& folder, const Network& network);

}  // namespace thalweg
