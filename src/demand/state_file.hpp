// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

namespace thalweg {

/// Copies a state that SUMO has saved (`--save-state.files`), without its flows: they are in the prepared
/// demand, vehicle by vehicle, and would insert everybody once more. InputError: no XML.
void copy_state_without_flows(const std::filesystem::path& from, const std::filesystem::path& to,
                              std::string_view header);

}  // namespace thalweg
