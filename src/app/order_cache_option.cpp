// SPDX-License-Identifier: Apache-2.0
#include "app/order_cache_option.hpp"

#include <cstdlib>

#include "app/messages.hpp"

namespace thalweg {

OptionSpec no_cache_option() {
  return {"processing", "no-cache", 0,
          "BOOL",       "false",    "Keeps nothing in the user's cache folder, and uses nothing there"};
}

OrderCache order_cache(const Options& options) {
  if (options.flag("no-cache")) return {};
  const auto folder = [](const char* variable) {
    const char* const value = std::getenv(variable);
    return std::filesystem::path(value == nullptr ? "" : value);
  };
  std::filesystem::path base = folder("XDG_CACHE_HOME");  // what is not absolute does not count, says XDG
  if (!base.is_absolute()) base = folder("HOME") / ".cache";
  if (!base.is_absolute()) return {};
  return {.folder = base / "thalweg", .warn = [](const std::string& text) { warn(text); }};
}

}  // namespace thalweg
