// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <optional>

#include "app/commands.hpp"
#include "app/messages.hpp"
#include "app/project.hpp"
#include "app/routing_options.hpp"
#include "app/start.hpp"
#include "app/sumo_words.hpp"
#include "core/error.hpp"
#include "core/number.hpp"
#include "report/comparison.hpp"
#include "report/decisions.hpp"
#include "report/gap.hpp"
#include "report/table.hpp"
#include "simulation/agenda.hpp"
#include "simulation/control.hpp"
#include "simulation/run_folder.hpp"
#include "simulation/sumo_module.hpp"
#include "sumo/program.hpp"
#include "traffic/memory_file.hpp"

namespace thalweg {
namespace {

/// Who waits for a person or a container counts from `begin` on.
std::vector<DemandedTrip> demanded(const Demand& demand, Millis begin, double share) {
  std::vector<DemandedTrip> trips;
  trips.reserve(demand.vehicles.size());
  for (const DemandVehicle& vehicle : demand.vehicles) {
    trips.push_back({.id = vehicle.id,
                     .depart = vehicle.depart.value_or(begin),
                     .fixed = vehicle.fixed,
                     .destination = vehicle.destination,
                     .equipped = is_equipped(vehicle, share),
                     .is_past = vehicle.depart.value_or(begin) < begin});
  }
  return trips;
}

/// The routes driven, where what follows "--" names a file of its own for them.
std::optional<std::filesystem::path> users_routes(const Options& options, const SumoOptions& catalogue) {
  std::optional<std::filesystem::path> file;
  const auto& arguments = options.for_sumo();
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const auto* option = catalogue.find_argument(arguments[i]);
    if (option == nullptr || option->first != "vehroute-output") continue;
    const auto equals = arguments[i].find('=');
    if (equals != std::string::npos) file = arguments[i].substr(equals + 1);
    if (equals == std::string::npos && i + 1 < arguments.size()) file = arguments[i + 1];
  }
  return file;
}

/// What only we asked for is not kept. A run that was interrupted before its first step has nothing to
/// measure.
void measure_gap(const Options& options, const Project& project, const RunFolder& folder,
                 const RunResult& result, RunSummary& summary) {
  const auto users = users_routes(options, project.catalogue);
  const std::filesystem::path routes = users.value_or(folder.routes);
  const bool is_xml = routes.string().ends_with(".xml") || routes.string().ends_with(".xml.gz");
  if (is_xml && result.end > result.begin)
    summary.gap = relative_gap(routes, folder.edge_data, project.network, project.demand);
  if (!users && !project.settings.find("vehroute-output")) std::filesystem::remove(folder.routes);
}

void tell_end(const RunResult& result, Millis stall) {
  if (result.reason == StopReason::stalled) {
    warn(fmt::format("nothing has arrived for {} s: the run is stopped at {} s (see --stall)",
                     format_seconds(stall), format_seconds(result.end)));
  }
  if (result.unreachable > 0)
    warn(fmt::format("{} time(s) no way led from a vehicle's road to where it must go; it kept its route",
                     result.unreachable));
  if (result.refused > 0)
    warn(fmt::format("SUMO refused {} route(s); those vehicles kept theirs", result.refused));
}

/// Runs the arm in its folder and fills the summary. What goes wrong is thrown.
RunResult simulate(const Options& options, const Project& project, const ArmSpec& arm,
                   const RunFolder& folder, RunSummary& summary) {
  ControlOptions control_with = control_options(options);
  control_with.lane_changes = project.lane_changes;
  control_with.seed = summary.seed;
  const std::string& decision_output = options.text("decision-output");
  std::optional<DecisionOutput> decisions;  // opened before the work, so that a bad name costs no run
  if (!decision_output.empty()) {
    decisions.emplace(project.output / decision_output, options.header());
    control_with.log_decisions = true;
  }
  if (const std::string& lessons = options.text("memory-output"); !lessons.empty()) {
    std::error_code error;  // told before the work, as that of the decisions
    std::filesystem::create_directories(lessons, error);
    verify(!error, fmt::format("cannot write to the folder '{}': {}", lessons, error.message()));
  }
  Memory memory;
  if (!options.text("memory-input").empty())
    memory = read_memory(options.text("memory-input"), project.network);
  StrategyOptions strategy_with = strategy_options(options);
  if (memory.days > 0) strategy_with.memory = &memory;
  const auto strategy = arm.ours ? make_strategy(arm.name, strategy_with) : nullptr;
  SessionSetup setup{.arguments = {"-c", folder.configuration.string()},
                     .network = &project.network,
                     .demand = &project.demand};
  setup.arguments.insert(setup.arguments.end(), options.for_sumo().begin(), options.for_sumo().end());

  const auto start = std::chrono::steady_clock::now();
  RunResult result;
  {
    const auto simulation = open_sumo(setup);
    ProgressLine progress;
    result = control(
        *simulation, project.network, project.demand, strategy.get(), control_with,
        [&](const Simulation& running) { progress.show(running); }, stop_requested);
    simulation->close();
  }
  summary.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  read_trips(folder.tripinfo, demanded(project.demand, result.begin, control_with.share), result.end,
             summary);
  read_statistics(folder.statistics, summary);
  if (arm.ours) summary.reroutes = result.reroutes;
  summary.ignored = result.ignored;
  summary.forecast_error = result.forecast_error;
  measure_gap(options, project, folder, result, summary);
  summary.router_cpu_s = arm.ours ? result.router_cpu_s : 0;
  summary.simulation_cpu_s = result.simulation_cpu_s;
  if (decisions) decisions->write(project.network, project.demand, result);
  const bool is_whole_day = result.reason != StopReason::interrupted;
  if (is_whole_day && !options.text("memory-output").empty()) {
    strategy->remember(memory);
    write_memory(options.text("memory-output"), project.network, memory, options.header());
  }
  tell_end(result, control_with.stall);
  return result;
}

/// Why a run failed. SUMO often throws no more than "Process Error": it has printed the reason.
std::string reason_of(std::string_view thrown, std::string_view printed) {
  constexpr std::string_view mark = "SUMO: ";
  if (printed.empty()) return std::string(thrown);
  const bool is_sumo = thrown.starts_with(mark);
  const bool is_told = is_sumo && printed.find(thrown.substr(mark.size())) != std::string_view::npos;
  if (is_told || thrown == "SUMO: Process Error") return fmt::format("{}{}", mark, printed);
  return fmt::format("{}\n{}", thrown, printed);
}

/// A run that fails as it starts leaves an empty log.
void keep(std::string_view words, const std::filesystem::path& log) {
  if (words.empty() || !log.is_absolute()) return;
  std::ofstream(log) << words;
}

/// Of an interrupted run the figures until then.
void print_table(const Project& project, RunSummary summary) {
  if (summary.error == was_interrupted) summary.exit = 0;
  const Comparison alone{.thalweg = THALWEG_VERSION,
                         .sumo = sumo_library_version(),
                         .configuration = project.name,
                         .command = {},
                         .seeds = {summary.seed},
                         .arms = {{.name = summary.arm, .runs = {summary}}}};
  fmt::print("{}", format_table(alone));
}

}  // namespace

Options run_options() {
  auto specs = project_options();
  std::string ours;
  for (const auto& entry : strategies()) ours += fmt::format("{}{}", ours.empty() ? "" : ", ", entry.name);
  const auto is_routing = [](const OptionSpec& spec) { return spec.section == "routing"; };
  specs.insert(std::find_if(specs.begin(), specs.end(), is_routing),
               {"routing", "strategy", 0, "STR", "forecast",
                ours + "; or SUMO's own: given, static, one-shot, device[:setting=value,..]"});
  specs.push_back({"random", "seed", 0, "INT", "23423", "SUMO's seed"});
  specs.push_back(
      {"output", "decision-output", 0, "STR", "", "Every routing decision (XML), in the output folder"});
  specs.push_back(
      {"input", "memory-input", 0, "FILE", "", "The folder of what the days before have taught (memory)"});
  specs.push_back(
      {"output", "memory-output", 0, "FILE", "", "The folder for that and what this run has lived"});
  return {"run", "one headless run of SUMO with one router in charge", std::move(specs)};
}

int run_command(std::span<const std::string> arguments) {
  Options options = run_options();
  if (!start(options, arguments, OwnConfiguration::no)) return 0;
  catch_interrupts();
  ArmSpec arm;
  const Project project = load_project(options, [&](const SumoOptions& catalogue) {
    arm = parse_arm(options.text("strategy"), catalogue);
    static_cast<void>(control_options(options));
    static_cast<void>(strategy_options(options));
    static_cast<void>(options.count("seed"));
    const bool has_memory = !options.text("memory-input").empty() || !options.text("memory-output").empty();
    verify(!has_memory || arm.name == "memory",
           "--memory-input and --memory-output go with --strategy memory: no other router has one");
  });
  warn_of_arms(project, {&arm, 1});
  const RunFolder folder =
      make_run_folder(project.output, project.settings, project.catalogue, project.demand_files, arm,
                      options.count("seed"), options.header());
  RunSummary summary;
  summary.arm = arm.name;
  summary.seed = options.count("seed");
  summary.dropped = project.demand.dropped.size();
  SumoWords words(pass_on);
  try {
    const RunResult result = simulate(options, project, arm, folder, summary);
    words.end(folder.errors.string());
    if (!words.errors().empty()) pass_on(fmt::format("Error: SUMO: {}\n", words.errors()));
    if (result.reason == StopReason::interrupted) {
      summary.exit = 1;
      summary.error = was_interrupted;
    }
  } catch (const std::exception& error) {  // whatever it is, what was found out is not lost
    words.end(folder.errors.string());
    if (read_text(folder.errors).empty()) keep(words.all(), folder.errors);
    summary.exit = 1;
    summary.error = reason_of(error.what(), words.errors());
    write_json(summary, folder.folder / "run.json");
    throw InputError(summary.error);
  }
  write_json(summary, folder.folder / "run.json");
  print_table(project, summary);
  if (summary.error == was_interrupted) {
    warn(fmt::format("interrupted at {:.2f} s: the outputs and figures are those of the run up to there",
                     summary.end_s));
  }
  return summary.exit;
}

}  // namespace thalweg
