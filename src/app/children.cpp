// SPDX-License-Identifier: Apache-2.0
#include "app/children.hpp"

#include <fmt/format.h>

#include <csignal>

#include "app/messages.hpp"
#include "core/number.hpp"
#include "demand/additional.hpp"
#include "report/comparison.hpp"
#include "sumo/ends_after_us.hpp"
#include "sumo/program.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;
namespace bp = boost::process;

/// What follows "--", with the outputs in the run's own folder: the runs would overwrite each other's.
std::vector<std::string> for_sumo(const Options& options, const SumoOptions& catalogue,
                                  const fs::path& folder) {
  OutputPlaces places(folder);
  std::vector<std::string> arguments = options.for_sumo();
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const auto* option = catalogue.find_argument(arguments[i]);
    if (option == nullptr || !SumoOptions::is_output(option->first, option->second)) continue;
    const auto equals = arguments[i].find('=');
    if (equals != std::string::npos) {
      arguments[i].replace(equals + 1, std::string::npos,
                           places.place(std::string_view(arguments[i]).substr(equals + 1), folder));
    } else if (i + 1 < arguments.size()) {
      arguments[i + 1] = places.place(arguments[i + 1], folder);
    }
  }
  return arguments;
}

}  // namespace

ChildRun child_run(const Options& options, const Project& project, const std::string& arm, std::uint64_t seed,
                   const fs::path& folder, std::span<const std::string> more) {
  std::vector<std::string> arguments{
      "run",           "--strategy",         arm,
      "--seed",        std::to_string(seed), "--output-folder",
      folder.string(), "--prepared",         project.demand_files.folder.string()};
  for (const OptionSpec& spec : project_options()) {
    const bool own = spec.name == "output-folder" || spec.name == "prepared" || spec.name == "strict";
    if (own || !options.on_command_line(spec.name)) continue;
    arguments.push_back(fmt::format("--{}={}", spec.name, options.text(spec.name)));
  }
  arguments.insert(arguments.end(), more.begin(), more.end());
  if (!options.for_sumo().empty()) arguments.emplace_back("--");
  for (auto& argument : for_sumo(options, project.catalogue, folder))
    arguments.push_back(std::move(argument));
  return {.arm = arm, .seed = seed, .folder = folder, .arguments = std::move(arguments)};
}

RunSummary run_child(const ChildRun& run) {
  fs::create_directories(run.folder);
  const fs::path result = run.folder / "run.json";
  const fs::path log = run.folder / "thalweg.log";
  std::error_code ignored;
  fs::remove(result, ignored);
  bp::child child(bp::exe = fs::read_symlink("/proc/self/exe").string(), bp::args = run.arguments,
                  bp::std_in<bp::null, (bp::std_out & bp::std_err)> log.string(), ends_after_us(SIGTERM));
  register_child(child.id());
  if (stop_requested) ::kill(child.id(), SIGTERM);  // it came before there was somebody to pass it on to
  child.wait();
  forget_child(child.id());
  if (fs::exists(result, ignored)) return read_run(result);
  const std::string words = read_text(log);
  const auto last = trimmed(std::string_view(words).substr(words.size() > 600 ? words.size() - 600 : 0));
  const int status = child.native_exit_code();
  const int exit = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : child.exit_code();
  RunSummary failed;
  failed.arm = run.arm;
  failed.seed = run.seed;
  failed.exit = exit == 0 ? 1 : exit;
  failed.error = last.empty() ? "it ended without a word" : std::string(last);
  return failed;
}

std::string command_line(std::string_view command, std::span<const std::string> arguments) {
  std::string text = fmt::format("thalweg {}", command);
  for (const auto& argument : arguments) {
    text +=
        argument.find_first_of(" '\"") == std::string::npos ? " " + argument : fmt::format(" '{}'", argument);
  }
  return text;
}

}  // namespace thalweg
