// SPDX-License-Identifier: Apache-2.0
#include "app/sumo_words.hpp"

#include <fmt/format.h>

#include <iostream>

#include "core/number.hpp"

namespace thalweg {
namespace {

constexpr std::string_view warning = "Warning: ";
constexpr std::string_view error = "Error: ";
constexpr std::size_t shown_of_kind = 3;

/// The line without its names and numbers.
std::string pattern_of(std::string_view line) {
  std::string pattern;
  while (!line.empty()) {
    const auto mark = line.find_first_of("'0123456789");
    pattern.append(line.substr(0, mark));
    if (mark == std::string_view::npos) break;
    pattern.push_back('*');
    const auto last =
        line[mark] == '\'' ? line.find('\'', mark + 1) : line.find_first_not_of("0123456789.", mark + 1) - 1;
    line.remove_prefix(std::min(last, line.size() - 1) + 1);
  }
  return pattern;
}

}  // namespace

SumoWords::SumoWords(std::function<void(std::string_view)> show)
    : show_(std::move(show)), stream_(std::cerr.rdbuf(this)) {}

SumoWords::~SumoWords() {
  if (stream_ != nullptr) std::cerr.rdbuf(stream_);
}

void SumoWords::end(std::string_view log) {
  std::cerr.rdbuf(stream_);
  stream_ = nullptr;
  if (line_ < all_.size()) take("\n");
  for (const Kind& kind : kinds_) {
    if (kind.count <= shown_of_kind) continue;
    show_(fmt::format("Warning: ... and {} more like this one of SUMO's: {} All are in '{}'.\n",
                      kind.count - shown_of_kind, trimmed(kind.first), log));
  }
}

std::string SumoWords::errors() const { return std::string(trimmed(errors_)); }

SumoWords::int_type SumoWords::overflow(int_type character) {
  if (character != traits_type::eof()) {
    const char one = traits_type::to_char_type(character);
    take({&one, 1});
  }
  return traits_type::not_eof(character);
}

std::streamsize SumoWords::xsputn(const char* text, std::streamsize count) {
  take({text, static_cast<std::size_t>(count)});
  return count;
}

void SumoWords::take(std::string_view text) {
  const std::scoped_lock lock(mutex_);
  all_.append(text);
  for (auto end = all_.find('\n', line_); end != std::string::npos; end = all_.find('\n', line_)) {
    take_line(std::string_view(all_).substr(line_, end + 1 - line_));
    line_ = end + 1;
  }
}

void SumoWords::take_line(std::string_view line) {
  if (!line.starts_with(' ')) {
    is_error_ = line.starts_with(error);
    is_shown_ = !is_error_ && (!line.starts_with(warning) || ++kind_of(line).count <= shown_of_kind);
    if (is_error_) line.remove_prefix(error.size());
  }
  if (is_error_) errors_.append(line);
  if (is_shown_) show_(line);
}

SumoWords::Kind& SumoWords::kind_of(std::string_view line) {
  const auto [place, is_new] = kind_of_pattern_.try_emplace(pattern_of(line), kinds_.size());
  if (is_new) kinds_.push_back({.first = std::string(line.substr(warning.size())), .count = 0});
  return kinds_[place->second];
}

}  // namespace thalweg
