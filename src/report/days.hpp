// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/trips.hpp"

namespace thalweg {

/// The same demand day after day under one router.
struct Days {
  std::string thalweg{};  ///< versions
  std::string sumo{};
  std::string configuration{};
  std::string command{};
  std::vector<std::string>
      run{};  ///< the arguments of the first day's run: what makes these days what they are
  std::vector<RunSummary> days{};
};

/// days.json: what stands above, and a day's entry as in comparison.json with its number, from 1 on.
void write_json(const Days& days, const std::filesystem::path& file);
Days read_days(const std::filesystem::path& file);  ///< InputError: missing or no days.json

/// What `thalweg days` prints, a line a day; every line ends with a newline.
std::string format_table(const Days& days);

}  // namespace thalweg
