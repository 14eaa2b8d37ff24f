// SPDX-License-Identifier: Apache-2.0
#include "report/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace thalweg {
namespace {

constexpr std::size_t line_width = 120;

}  // namespace

std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

void TextTable::print(std::string& out) const {
  out += fmt::format("\n{}\n", title_);
  for (std::size_t row = 0; row <= labels_.size(); ++row) {
    const std::string label = row == 0 ? "" : labels_[row - 1];
    std::string line = "  " + label + std::string(label_width_ - width_of(label), ' ');
    for (const Cells& column : columns_) {
      std::size_t width = 0;
      for (const auto& cell : column) width = std::max(width, width_of(cell));
      line += "  " + std::string(width - width_of(column[row]), ' ') + column[row];
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + '\n';
  }
}

std::string decimals(double value, int digits, bool sign) {
  if (!std::isfinite(value)) return "-";
  std::string text = sign ? fmt::format("{:+.{}f}", value, digits) : fmt::format("{:.{}f}", value, digits);
  if (text.find_first_not_of("+-0.") == std::string::npos) text.erase(0, text.find('0'));  // no "-0.0"
  return text;
}

std::string with_interval(const Estimate& estimate) {
  if (!estimate.half_width) return decimals(estimate.mean, 1);
  return decimals(estimate.mean, 1) + " ±" + decimals(*estimate.half_width, 1);
}

std::string count_text(double mean) { return decimals(mean, mean == std::floor(mean) ? 0 : 1); }

std::string wrapped(std::string_view first, std::string_view text) {
  std::string out;
  std::string line(first);
  const std::string indent(width_of(first), ' ');
  bool fresh = true;
  while (!text.empty()) {
    const auto blank = text.find_first_of(" \n");
    const auto word = text.substr(0, blank);
    text.remove_prefix(blank == std::string_view::npos ? text.size() : blank + 1);
    if (word.empty()) continue;
    if (!fresh && width_of(line) + 1 + width_of(word) > line_width) {
      out += line + '\n';
      line = indent;
      fresh = true;
    }
    if (!fresh) line += ' ';
    line += word;
    fresh = false;
  }
  return out + line + '\n';
}

}  // namespace thalweg
