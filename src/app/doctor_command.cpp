// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>

#include "app/commands.hpp"
#include "app/start.hpp"
#include "core/error.hpp"
#include "core/number.hpp"
#include "simulation/sumo_module.hpp"
#include "sumo/installation.hpp"
#include "sumo/program.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

/// One line of the report; false when something is missing.
bool tell(std::string_view what, const std::string& found, std::string_view mend) {
  if (found.empty()) {
    fmt::print("{:<16} missing: {}\n", what, mend);
  } else {
    fmt::print("{:<16} {}\n", what, found);
  }
  return !found.empty();
}

std::string version_of(const fs::path& tool) {
  const fs::path log = fs::temp_directory_path() / fmt::format("thalweg-doctor-{}.log", getpid());
  const int exit = tool.empty() ? 1 : run_program(tool, {"--version"}, log);
  const std::string text = read_text(log);
  std::error_code ignored;
  fs::remove(log, ignored);
  const auto lines = split(text, "\n");
  if (exit == 0 && !lines.empty()) return fmt::format("{} ({})", tool.string(), trimmed(lines.front()));
  if (!tool.empty())
    fmt::print("{} does not run: {}\n", tool.string(), trimmed(std::string_view(text).substr(0, 200)));
  return {};
}

}  // namespace

int doctor_command(std::span<const std::string> arguments) {
  Options options("doctor", "which SUMO is used, and what is missing", {});
  if (!start(options, arguments, OwnConfiguration::no)) return 0;
  constexpr std::string_view mend = "run tools/setup, then tools/build (or give cmake -DSUMO_ROOT=...)";
  const SumoInstallation sumo = find_sumo();
  prepare_environment(sumo);
  bool complete = true;
  fmt::print("{:<16} {}\n", "thalweg", THALWEG_VERSION);
  tell("SUMO_HOME", sumo.home.string(),
       "SUMO does not validate its input then, all else works (Debian: apt install sumo-tools)");
  std::string library;
  std::string problem(mend);
  try {
    library = sumo_library_version();
  } catch (const InputError& error) {
    problem = error.what();
  }
  complete &= tell("libsumo", library, problem);
  const std::string binary = version_of(sumo.sumo);
  complete &= tell("sumo", binary, mend);
  complete &= tell("duarouter", version_of(sumo.duarouter), mend);
  const char* user_home = std::getenv("SUMO_HOME");
  std::error_code ignored;
  if (user_home != nullptr && !sumo.home.empty() && !fs::equivalent(user_home, sumo.home, ignored)) {
    fmt::print(
        "Warning: $SUMO_HOME is {}, but thalweg was built against {}: unset it, or build with it set.\n",
        user_home, sumo.home.string());
  }
  const auto number = library.substr(std::min(library.find(' ') + 1, library.size()));
  if (!library.empty() && binary.find(number) == std::string::npos) {
    fmt::print("Warning: libsumo is {} but sumo is another version.\n", number);
  }
  fmt::print("{}\n", complete ? "All is there." : "Something is missing: the lines above say what to do.");
  return complete ? 0 : 1;
}

}  // namespace thalweg
