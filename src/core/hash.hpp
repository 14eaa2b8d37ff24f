// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace thalweg {

/// FNV-1a with a final mix: the same on every machine and for every compiler, unlike std::hash.
constexpr std::uint64_t stable_hash(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  hash ^= hash >> 33U;
  hash *= 0xff51afd7ed558ccdULL;
  hash ^= hash >> 33U;
  return hash;
}

/// A number in [0, 1) that belongs to the text.
constexpr double unit_hash(std::string_view text) {
  return static_cast<double>(stable_hash(text) >> 11U) * 0x1p-53;
}

}  // namespace thalweg
