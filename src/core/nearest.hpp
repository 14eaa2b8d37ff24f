// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace thalweg {

/// The name of `names` with the fewest changed letters (Levenshtein); empty when none is near.
std::string nearest_name(std::string_view wanted, std::span<const std::string> names);

/// " (did you mean 'x'?)" or nothing.
std::string did_you_mean(std::string_view wanted, std::span<const std::string> names);

}  // namespace thalweg
