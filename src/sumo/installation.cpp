// SPDX-License-Identifier: Apache-2.0
#include "sumo/installation.hpp"

#include <fmt/format.h>

#include <boost/process/search_path.hpp>
#include <cstdlib>

#include "core/error.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

bool is_home(const fs::path& path) {
  std::error_code ignored;
  return !path.empty() && fs::exists(path / "data" / "xsd", ignored);
}

fs::path environment_path(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? fs::path() : fs::path(value);
}

/// The wheel keeps bin/ within its home, Debian keeps it beside share/sumo.
fs::path find_tool(const fs::path& home, const char* name) {
  std::error_code ignored;
  for (const fs::path& folder : {home / "bin", home / ".." / ".." / "bin"}) {
    fs::path tool = (folder / name).lexically_normal();
    if (!home.empty() && fs::exists(tool, ignored)) return tool;
  }
  return boost::process::search_path(name).string();
}

void set_if_missing(const char* name, const fs::path& value) { setenv(name, value.c_str(), 0); }

}  // namespace

SumoInstallation find_sumo() {
  SumoInstallation sumo;
  for (const fs::path& home : {fs::path(THALWEG_SUMO_HOME), environment_path("SUMO_HOME")}) {
    if (sumo.home.empty() && is_home(home)) sumo.home = home;
  }
  sumo.sumo = find_tool(sumo.home, "sumo");
  sumo.duarouter = find_tool(sumo.home, "duarouter");
  return sumo;
}

void prepare_environment(const SumoInstallation& sumo) {
  if (sumo.home.empty()) return;
  set_if_missing("SUMO_HOME", sumo.home);
  std::error_code ignored;
  const fs::path projections = sumo.home / "data" / "proj";
  if (!fs::exists(projections, ignored)) return;
  set_if_missing("PROJ_DATA", projections);
  set_if_missing("PROJ_LIB", projections);
}

void require_tool(const fs::path& tool, const std::string& name) {
  if (!tool.empty()) return;
  throw InputError(
      fmt::format("SUMO's {} was not found: install SUMO with tools/setup, or set SUMO_HOME ('thalweg "
                  "doctor' tells more)",
                  name));
}

}  // namespace thalweg
