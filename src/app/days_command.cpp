// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "app/children.hpp"
#include "app/commands.hpp"
#include "app/messages.hpp"
#include "app/project.hpp"
#include "app/routing_options.hpp"
#include "app/start.hpp"
#include "core/error.hpp"
#include "report/days.hpp"
#include "simulation/arm.hpp"
#include "simulation/sumo_module.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

Options days_options() {
  auto specs = project_options();
  specs.push_back({"routing", "strategy", 0, "STR", "memory",
                   "Who routes; only 'memory' learns from day to day, all others begin anew"});
  specs.push_back({"random", "days", 0, "INT", "10", "How many"});
  specs.push_back({"random", "seed", 0, "INT", "23423", "Of the first day; each day after has the next"});
  specs.push_back({"random", "same-seed", 0, "BOOL", "false", "Every day has the seed of the first"});
  return {"days", "day after day on the same demand: what does a router learn from the days before?",
          std::move(specs)};
}

std::uint64_t seed_of_day(const Options& options, std::size_t day) {
  return options.count("seed") + (options.flag("same-seed") ? 0 : day - 1);
}

/// The run of one day (from 1 on), in a folder of its own. What it learns is in its folder `memory`.
ChildRun run_of_day(const Options& options, const Project& project, const std::string& strategy,
                    std::size_t day) {
  const auto folder = [&](std::size_t of) { return project.output / fmt::format("day-{:03}", of); };
  std::vector<std::string> more;
  if (strategy == "memory") {
    more = {"--memory-output", (folder(day) / "memory").string()};
    if (day > 1) {
      more.emplace_back("--memory-input");
      more.push_back((folder(day - 1) / "memory").string());
    }
  }
  return child_run(options, project, strategy, seed_of_day(options, day), folder(day), more);
}

/// The days that an earlier call has left in the folder: it goes on from there. One that failed is done
/// again.
std::vector<RunSummary> days_before(const Options& options, const fs::path& file,
                                    const std::vector<std::string>& run) {
  if (!fs::exists(file)) return {};
  Days before = read_days(file);
  bool is_same = before.run == run;
  for (std::size_t i = 0; i < before.days.size(); ++i)
    is_same = is_same && before.days[i].seed == seed_of_day(options, i + 1);
  verify(is_same, fmt::format("'{}' holds days of another call ({}): name another --output-folder",
                              file.string(), before.command));
  while (!before.days.empty() && before.days.back().failed()) before.days.pop_back();
  return before.days;
}

}  // namespace

int days_command(std::span<const std::string> arguments) {
  Options options = days_options();
  if (!start(options, arguments, OwnConfiguration::no)) return 0;
  catch_interrupts();
  std::uint64_t count = 0;
  ArmSpec arm;
  const Project project = load_project(options, [&](const SumoOptions& catalogue) {
    count = options.count("days");
    verify(count >= 1 && count <= 999, "--days must be from 1 to 999");
    arm = parse_arm(options.text("strategy"), catalogue);
    static_cast<void>(options.count("seed"));
    static_cast<void>(control_options(options));
    static_cast<void>(strategy_options(options));
  });
  warn_of_arms(project, {&arm, 1});
  const fs::path file = project.output / "days.json";
  Days days{.thalweg = THALWEG_VERSION,
            .sumo = sumo_library_version(),
            .configuration = project.name,
            .command = command_line("days", arguments),
            .run = run_of_day(options, project, arm.name, 1).arguments};
  days.days = days_before(options, file, days.run);
  if (!days.days.empty())
    warn(fmt::format("{} day(s) are there already: it goes on after them", days.days.size()));
  ProgressLine progress;
  while (days.days.size() < count && !stop_requested) {
    progress.show(fmt::format("day {} of {}", days.days.size() + 1, count));
    days.days.push_back(run_child(run_of_day(options, project, arm.name, days.days.size() + 1)));
    write_json(days, file);
    if (days.days.back().failed()) break;  // the next would learn from it
  }
  fmt::print("{}", format_table(days));
  if (stop_requested) warn("interrupted: the same call goes on after the last day that was finished");
  return days.days.size() >= count && !days.days.back().failed() ? 0 : 1;
}

}  // namespace thalweg
