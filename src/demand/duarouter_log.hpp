// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>

namespace thalweg {

/// Why duarouter left somebody out: the first message of its log that names a vehicle, trip or flow, by its
/// id, with the lines that go on about it ("Set option '--junction-taz' ..").
std::unordered_map<std::string, std::string> reasons_of(std::string_view log);
/// The same of persons and containers, whose ids may be those of vehicles.
std::unordered_map<std::string, std::string> reasons_of_persons(std::string_view log);

}  // namespace thalweg
