// SPDX-License-Identifier: Apache-2.0
#include "demand/duarouter_log.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "core/number.hpp"

namespace thalweg {
namespace {

using Marks = std::span<const std::string_view>;

/// The id after one of the marks: "Warning: ... vehicle 'x' ..." or "Vehicle 'x' ..." or "... for trip 'x'!".
std::optional<std::string> named_in(std::string_view line, Marks marks) {
  for (const auto mark : marks) {
    const auto at = line.find(mark);
    if (at == std::string_view::npos) continue;
    const auto id = line.substr(at + mark.size());
    if (const auto end = id.find('\''); end != std::string_view::npos) return std::string(id.substr(0, end));
  }
  return std::nullopt;
}

bool goes_on(std::string_view line) {
  static constexpr std::array<std::string_view, 5> others{"Warning: ", "Error: ", "Success", "Quitting",
                                                          "Vehicle '"};
  return std::none_of(others.begin(), others.end(), [&](auto start) { return line.starts_with(start); });
}

std::unordered_map<std::string, std::string> reasons_of(std::string_view log, Marks marks) {
  std::unordered_map<std::string, std::string> reasons;
  std::string* open = nullptr;
  for (const auto line : split(log, "\n\r")) {
    const auto id = named_in(line, marks);
    if (!id) {
      if (open != nullptr && goes_on(line)) {
        open->append(" ").append(trimmed(line));
      } else {
        open = nullptr;
      }
      continue;
    }
    constexpr std::string_view warning = "Warning: ";
    const auto [entry, is_first] =
        reasons.try_emplace(*id, line.starts_with(warning) ? line.substr(warning.size()) : line);
    open = is_first ? &entry->second : nullptr;
  }
  return reasons;
}

}  // namespace

std::unordered_map<std::string, std::string> reasons_of(std::string_view log) {
  static constexpr std::array<std::string_view, 3> marks{"ehicle '", "trip '", "flow '"};
  return reasons_of(log, marks);
}

std::unordered_map<std::string, std::string> reasons_of_persons(std::string_view log) {
  static constexpr std::array<std::string_view, 2> marks{"person '", "container '"};
  return reasons_of(log, marks);
}

}  // namespace thalweg
