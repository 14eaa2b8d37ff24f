// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "sumo/configuration.hpp"
#include "sumo/installation.hpp"

namespace thalweg {

/// duarouter with what all its calls share.
class Duarouter {
 public:
  /// Its log is written to `folder`. A set `stop` ends it.
  Duarouter(const Settings& settings, const SumoInstallation& sumo, const std::filesystem::path& folder,
            const std::atomic<bool>& stop);

  /// Routes `inputs` into `output`; returns what duarouter printed. InputError with its words when it fails.
  std::string route(const std::string& inputs, const std::filesystem::path& output,
                    std::vector<std::string> more) const;

 private:
  void add(std::string name, std::string value);

  std::filesystem::path program_;
  std::filesystem::path folder_;
  const std::atomic<bool>& stop_;
  std::vector<std::string> common_;
};

}  // namespace thalweg
