// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <mutex>

#include "app/children.hpp"
#include "app/commands.hpp"
#include "app/messages.hpp"
#include "app/project.hpp"
#include "app/routing_options.hpp"
#include "app/start.hpp"
#include "core/error.hpp"
#include "core/number.hpp"
#include "core/parallel.hpp"
#include "report/comparison.hpp"
#include "report/table.hpp"
#include "simulation/arm.hpp"
#include "simulation/sumo_module.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

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

/// All jobs, `workers` at a time. The order of the results is that of the jobs.
std::vector<RunSummary> run_jobs(const std::vector<ChildRun>& jobs, std::size_t workers) {
  std::vector<RunSummary> results(jobs.size());
  std::size_t done = 0;
  std::mutex mutex;
  ProgressLine progress;
  parallel_for(jobs.size(), workers, [&](std::size_t i, std::size_t) {
    if (stop_requested) return;
    try {
      results[i] = run_child(jobs[i]);
    } catch (const std::exception& error) {  // one run's failure does not end the others
      results[i] = {.arm = jobs[i].arm, .seed = jobs[i].seed, .exit = 1, .error = error.what()};
    }
    const std::scoped_lock lock(mutex);
    progress.show(fmt::format("{} of {} runs done, the last: {}, seed {}", ++done, jobs.size(), jobs[i].arm,
                              jobs[i].seed));
  });
  return results;
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
  std::vector<ArmSpec> arms;
  const Project project = load_project(options, [&](const SumoOptions& catalogue) {
    jobs_at_a_time = options.count("jobs");
    verify(jobs_at_a_time >= 1 && jobs_at_a_time <= 64, "--jobs must be from 1 to 64");
    comparison.seeds = seeds_of(options);
    verify(!has_twins(comparison.seeds), "--seeds names a seed twice");
    names = split_arms(options.text("arms"));
    verify(!names.empty(), "--arms names no arm");
    verify(!has_twins(names), "--arms names an arm twice");
    for (const auto& name : names) arms.push_back(parse_arm(name, catalogue));
    static_cast<void>(control_options(options));
    static_cast<void>(strategy_options(options));
  });
  warn_of_arms(project, arms);
  for (const ArmSpec& arm : arms) comparison.arms.push_back({.name = arm.name});
  comparison.thalweg = THALWEG_VERSION;
  comparison.sumo = sumo_library_version();
  comparison.configuration = project.name;
  comparison.command = command_line("compare", arguments);

  std::vector<ChildRun> jobs;  // seed by seed, so that an early end leaves whole seeds
  for (const std::uint64_t seed : comparison.seeds) {
    for (const std::string& name : names) {
      const fs::path folder = project.output / arm_folder(name) / std::to_string(seed);
      jobs.push_back(child_run(options, project, name, seed, folder));
    }
  }
  const auto results = run_jobs(jobs, jobs_at_a_time);
  bool complete = true;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (results[i].arm.empty()) continue;  // not started: interrupted
    comparison.arms[i % names.size()].runs.push_back(results[i]);
    complete = complete && !results[i].failed();
  }
  write_json(comparison, project.output / "comparison.json");
  fmt::print("{}", format_table(comparison));
  if (stop_requested) warn("interrupted: what was finished is above and in comparison.json");
  return complete && !stop_requested ? 0 : 1;
}

}  // namespace thalweg
