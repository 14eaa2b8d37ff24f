// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <vector>

namespace thalweg {

constexpr std::string_view trimmed(std::string_view text) {
  constexpr std::string_view space = " \t\r\n";
  const auto first = text.find_first_not_of(space);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(space) - first + 1);
}

/// The whole of `text` (blanks around it allowed) as a finite number, independent of the locale; else
/// nullopt.
inline std::optional<double> parse_number(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool finite = value - value == 0;
  if (error != std::errc{} || end != text.data() + text.size() || !finite) return std::nullopt;
  return value;
}

/// The whole of `text` as an integer; else nullopt.
template <class Integer>
std::optional<Integer> parse_integer(std::string_view text) {
  text = trimmed(text);
  Integer value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || text.empty()) return std::nullopt;
  return value;
}

/// The non-empty parts of `text` between any of `separators`. The views point into `text`.
inline std::vector<std::string_view> split(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> parts;
  while (true) {
    const auto first = text.find_first_not_of(separators);
    if (first == std::string_view::npos) return parts;
    const auto length = text.substr(first).find_first_of(separators);
    parts.push_back(text.substr(first, length));
    if (length == std::string_view::npos) return parts;
    text.remove_prefix(first + length);
  }
}

}  // namespace thalweg
