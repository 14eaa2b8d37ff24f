// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace thalweg {

/// Where a run's outputs go: every file that the user's configuration or additional files would write lands
/// in the run's own folder, under its own name as far as that is free.
class OutputPlaces {
 public:
  /// `prefix` and `suffix` of the name of every file, the suffix before ".xml" or ".xml.gz"; times filled in.
  explicit OutputPlaces(std::filesystem::path folder, std::string prefix = {}, std::string suffix = {})
      : folder_(std::move(folder)), prefix_(std::move(prefix)), suffix_(std::move(suffix)) {}

  /// `value` as the user wrote it in a file of `from`. Special names (NUL, stdout, host:port ..) stay.
  std::string place(std::string_view value, const std::filesystem::path& from);

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
  std::string prefix_;
  std::string suffix_;
  std::map<std::filesystem::path, std::filesystem::path> taken_;  ///< place -> what the user called it
};

/// Copies an additional file for one run: outputs to their places, inputs by absolute path, demand left out
/// (it is in the prepared file), and nothing that switches device.rerouting on.
/// `for_duarouter`: without calibrators as well, on which SUMO 1.28's duarouter crashes.
void rewrite_additional(const std::filesystem::path& from, const std::filesystem::path& to,
                        OutputPlaces& places, bool for_duarouter);

/// <param> keys that would hand a vehicle to SUMO's own router.
bool switches_rerouting(std::string_view key);

}  // namespace thalweg
