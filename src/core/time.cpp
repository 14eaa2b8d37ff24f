// SPDX-License-Identifier: Apache-2.0
#include "core/time.hpp"

#include <fmt/format.h>

#include <array>

#include "core/number.hpp"

namespace thalweg {

std::optional<Millis> parse_time(std::string_view text) {
  if (text.find(':') == std::string_view::npos) {
    const auto seconds = parse_number(text);
    if (!seconds) return std::nullopt;
    return from_seconds(*seconds);
  }
  const bool negative = !text.empty() && text.front() == '-';
  if (negative) text.remove_prefix(1);
  std::array<double, 4> fields{};
  std::size_t count = 0;
  while (true) {
    const auto colon = text.find(':');
    const auto field = parse_number(text.substr(0, colon));
    if (!field || *field < 0 || count == fields.size()) return std::nullopt;
    fields[count++] = *field;
    if (colon == std::string_view::npos) break;
    text.remove_prefix(colon + 1);
  }
  if (count < 3) return std::nullopt;
  constexpr std::array<double, 4> unit{86400.0, 3600.0, 60.0, 1.0};
  double seconds = 0;
  for (std::size_t i = 0; i < count; ++i) seconds += fields[i] * unit[unit.size() - count + i];
  return from_seconds(negative ? -seconds : seconds);
}

std::string format_seconds(Millis t) { return fmt::format("{:.2f}", to_seconds(t)); }

}  // namespace thalweg
