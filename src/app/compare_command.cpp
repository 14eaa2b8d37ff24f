// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <boost/process.hpp>
#include <mutex>

#include "app/commands.hpp"
#include "app/messages.hpp"
#include "app/project.hpp"
#include "app/routing_options.hpp"
#include "app/start.hpp"
#include "core/error.hpp"
#include "core/number.hpp"
#include "core/parallel.hpp"
#include "demand/additional.hpp"
#include "report/comparison.hpp"
#include "report/table.hpp"
#include "simulation/arm.hpp"
#include "simulation/sumo_module.hpp"
#include "sumo/program.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;
namespace bp = boost::process;

/// One arm with one seed, in a process of its own: libsumo holds one simulation a process.
struct Job {
  std::size_t arm;
  std::uint64_t seed;
  fs::path folder;
  std::vector<std::string> arguments;
};

std::vector<std::uint64_t> seeds_of(const Options& options) {
  std::vector<std::uint64_t> seeds;
  const std::string& text = options.text("seeds");
  if (text.find(',') != std::string::npos) {
    for (const auto part : split(text, ",")) {
      const auto seed = parse_integer<std::uint64_t>(part);
      verify(seed.has_value(), fmt::format("--seeds {}: '{}' is no seed", text, part));
      seeds.push_back(*seed);
    }
    verify(!seeds.empty(), fmt::format("--seeds {}: there is no seed in this list", text));
    return seeds;
  }
  const std::uint64_t count = options.count("seeds");
  verify(count >= 1, "--seeds must be at least 1");
  for (std::uint64_t i = 0; i < count; ++i) seeds.push_back(options.count("seed") + i);
  return seeds;
}

/// Two runs in one folder would overwrite each other.
template <class T>
bool has_twins(std::vector<T> values) {
  std::sort(values.begin(), values.end());
  return std::adjacent_find(values.begin(), values.end()) != values.end();
}

/// What follows "--", with the outputs in the run's own folder: the runs would overwrite each other's.
std::vector<std::string> for_sumo(const Options& options, const SumoOptions& catalogue,
                                  const fs::path& folder) {
  OutputPlaces places(folder, "");
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

/// The call of `thalweg run` for one arm and seed: what the command line says, and where the prepared demand
/// is.
std::vector<std::string> child_arguments(const Options& options, const Project& project,
                                         const std::string& arm, std::uint64_t seed, const fs::path& folder) {
  std::vector<std::string> arguments{
      "run",           "--strategy",         arm,
      "--seed",        std::to_string(seed), "--output-folder",
      folder.string(), "--prepared",         project.demand_files.folder.string()};
  for (const OptionSpec& spec : project_options()) {
    const bool own = spec.name == "output-folder" || spec.name == "prepared" || spec.name == "strict";
    if (own || !options.on_command_line(spec.name)) continue;
    arguments.push_back(fmt::format("--{}={}", spec.name, options.text(spec.name)));
  }
  if (!options.for_sumo().empty()) arguments.emplace_back("--");
  for (auto& argument : for_sumo(options, project.catalogue, folder))
    arguments.push_back(std::move(argument));
  return arguments;
}

/// Runs the child to its end and reads what it left. A child that died is a failed run with its last words.
RunSummary run_job(const Job& job, const std::string& arm) {
  fs::create_directories(job.folder);
  const fs::path result = job.folder / "run.json";
  const fs::path log = job.folder / "thalweg.log";
  std::error_code ignored;
  fs::remove(result, ignored);
  bp::child child(bp::exe = fs::read_symlink("/proc/self/exe").string(), bp::args = job.arguments,
                  bp::std_in<bp::null, (bp::std_out & bp::std_err)> log.string());
  register_child(child.id());
  child.wait();
  forget_child(child.id());
  const std::string words = read_text(log);
  const auto last = trimmed(std::string_view(words).substr(words.size() > 600 ? words.size() - 600 : 0));
  if (fs::exists(result, ignored)) {
    RunSummary summary = read_run(result);
    // SUMO prints what it does not like of its options before it opens its error log: only the log has it.
    if (summary.failed() && !last.empty()) summary.error = last;
    return summary;
  }
  const int status = child.native_exit_code();
  const int exit = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : child.exit_code();
  RunSummary failed;
  failed.arm = arm;
  failed.seed = job.seed;
  failed.exit = exit == 0 ? 1 : exit;
  failed.error = last.empty() ? "it ended without a word" : std::string(last);
  return failed;
}

/// All jobs, `workers` at a time. The order of the results is that of the jobs.
std::vector<RunSummary> run_jobs(const std::vector<Job>& jobs, const std::vector<std::string>& arms,
                                 std::size_t workers) {
  std::vector<RunSummary> results(jobs.size());
  std::size_t done = 0;
  std::mutex mutex;
  ProgressLine progress;
  parallel_for(jobs.size(), workers, [&](std::size_t i, std::size_t) {
    if (stop_requested) return;
    const std::string& arm = arms[jobs[i].arm];
    try {
      results[i] = run_job(jobs[i], arm);
    } catch (const std::exception& error) {  // one run's failure does not end the others
      results[i] = {.arm = arm, .seed = jobs[i].seed, .exit = 1, .error = error.what()};
    }
    const std::scoped_lock lock(mutex);
    progress.show(
        fmt::format("{} of {} runs done, the last: {}, seed {}", ++done, jobs.size(), arm, jobs[i].seed));
  });
  return results;
}

std::string command_line(std::span<const std::string> arguments) {
  std::string text = "thalweg compare";
  for (const auto& argument : arguments) {
    text +=
        argument.find_first_of(" '\"") == std::string::npos ? " " + argument : fmt::format(" '{}'", argument);
  }
  return text;
}

Options compare_options() {
  auto specs = project_options();
  specs.push_back(
      {"routing", "arms", 0, "STR", "given,static,one-shot,device,hybrid,evolved,forecast",
       "What is compared: strategies and SUMO's own (device:period=120,probability=0.5 for any setting)"});
  specs.push_back({"random", "seeds", 0, "STR", "10", "How many seeds, or a list of them"});
  specs.push_back({"random", "seed", 0, "INT", "23423", "The first seed"});
  specs.push_back({"processing", "jobs", 'j', "INT", "1", "Runs at a time"});
  return {"compare", "the same demand under several routers and seeds: who arrives earlier?",
          std::move(specs)};
}

}  // namespace

int compare_command(std::span<const std::string> arguments) {
  Options options = compare_options();
  if (!start(options, arguments, OwnConfiguration::no)) return 0;
  catch_interrupts();
  Comparison comparison;
  std::uint64_t jobs_at_a_time = 1;
  std::vector<std::string> names;
  const Project project = load_project(options, [&](const SumoOptions& catalogue) {
    jobs_at_a_time = options.count("jobs");
    verify(jobs_at_a_time >= 1 && jobs_at_a_time <= 64, "--jobs must be from 1 to 64");
    comparison.seeds = seeds_of(options);
    verify(!has_twins(comparison.seeds), "--seeds names a seed twice");
    names = split_arms(options.text("arms"));
    verify(!names.empty(), "--arms names no arm");
    verify(!has_twins(names), "--arms names an arm twice");
    for (const auto& name : names) comparison.arms.push_back({.name = parse_arm(name, catalogue).name});
    static_cast<void>(control_options(options));
    static_cast<void>(strategy_options(options));
  });
  comparison.thalweg = THALWEG_VERSION;
  comparison.sumo = sumo_library_version();
  comparison.configuration = project.name;
  comparison.command = command_line(arguments);

  std::vector<Job> jobs;  // seed by seed, so that an early end leaves whole seeds
  for (const std::uint64_t seed : comparison.seeds) {
    for (std::size_t arm = 0; arm < names.size(); ++arm) {
      const fs::path folder = project.output / arm_folder(names[arm]) / std::to_string(seed);
      jobs.push_back({.arm = arm,
                      .seed = seed,
                      .folder = folder,
                      .arguments = child_arguments(options, project, names[arm], seed, folder)});
    }
  }
  const auto results = run_jobs(jobs, names, jobs_at_a_time);
  bool complete = true;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (results[i].arm.empty()) continue;  // not started: interrupted
    comparison.arms[jobs[i].arm].runs.push_back(results[i]);
    complete = complete && !results[i].failed();
  }
  write_json(comparison, project.output / "comparison.json");
  fmt::print("{}", format_table(comparison));
  if (stop_requested) warn("interrupted: what was finished is above and in comparison.json");
  return complete && !stop_requested ? 0 : 1;
}

}  // namespace thalweg
