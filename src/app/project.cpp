// SPDX-License-Identifier: Apache-2.0
#include "app/project.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <ctime>
#include <utility>

#include "app/messages.hpp"
#include "app/routing_options.hpp"
#include "core/error.hpp"
#include "core/nearest.hpp"
#include "network/read_network.hpp"
#include "simulation/run_folder.hpp"
#include "xml/writer.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

/// Options of ours that are SUMO's as well: the command line overrides the user's configuration.
constexpr std::array<std::string_view, 9> shared_with_sumo{"net-file",
                                                           "route-files",
                                                           "additional-files",
                                                           "begin",
                                                           "end",
                                                           "step-length",
                                                           "weights.minor-penalty",
                                                           "weights.turnaround-penalty",
                                                           "weights.tls-penalty"};

struct Configuration {
  fs::path file;
  std::vector<Setting> settings;
};

/// This one last, after those that it names in turn: --save-configuration writes the name of the one that was
/// given, and what a file says itself counts more. SUMO does not look at such a name, and runs a file whose
/// name leads nowhere or back to it; so do we.
std::vector<Configuration> with_named_ones(const fs::path& file) {
  std::vector<Configuration> found;
  for (fs::path next = file;;) {
    found.push_back({.file = next, .settings = read_configuration(next)});
    const auto& settings = found.back().settings;
    const auto named = std::ranges::find(settings, "configuration-file", &Setting::name);
    next = named == settings.end() ? "" : resolve_files(named->value, fs::absolute(next).parent_path());
    const auto is_next = [&](const Configuration& known) { return fs::equivalent(known.file, next); };
    if (!fs::is_regular_file(next) || std::ranges::any_of(found, is_next)) break;
  }
  std::ranges::reverse(found);
  return found;
}

void read_user_configuration(Options& options, Project& project, const Configuration& configuration) {
  const fs::path& file = configuration.file;
  std::vector<std::string> names = project.catalogue.names();
  for (const auto& spec : options.specs()) names.push_back(spec.name);
  for (const Setting& setting : configuration.settings) {
    const auto* option = project.catalogue.find(setting.name);
    const std::string name = option == nullptr ? setting.name : option->first;
    const bool ours = options.take({.name = name, .value = setting.value});
    if (option == nullptr && !ours) {
      throw InputError(fmt::format("{}: no option with the name '{}' exists{}", file.string(), setting.name,
                                   did_you_mean(setting.name, names)));
    }
    if (option == nullptr) continue;
    const bool is_input = SumoOptions::is_input(name, option->second);
    project.settings.set(
        name, is_input ? resolve_files(setting.value, fs::absolute(file).parent_path()) : setting.value);
  }
}

void apply_command_line(const Options& options, Project& project) {
  for (const auto name : shared_with_sumo) {
    const auto* option = project.catalogue.find(name);
    if (!options.on_command_line(name) || option == nullptr) continue;
    const bool is_input = SumoOptions::is_input(name, option->second);
    project.settings.set(
        name, is_input ? resolve_files(options.text(name), fs::current_path()) : options.text(name));
  }
  if (options.is_set("output-prefix")) project.settings.set("output-prefix", options.text("output-prefix"));
}

/// SUMO puts the time in place of TIME and of variables when it opens a file, and only then. Here the names
/// of the files are made before, and those that are read afterwards must be known.
void fill_in_time(Settings& settings) {
  const std::time_t now = std::time(nullptr);
  const auto words = [&](std::tm* (*of)(const std::time_t*, std::tm*)) {
    std::tm time{};
    return fmt::format("{:%Y-%m-%d-%H-%M-%S}", *of(&now, &time));
  };
  const std::array<std::pair<std::string_view, std::string>, 4> values{{{"${LOCALTIME}", words(localtime_r)},
                                                                        {"${UTC}", words(gmtime_r)},
                                                                        {"${PID}", std::to_string(getpid())},
                                                                        {"TIME", words(localtime_r)}}};
  for (const char* option : {"output-prefix", "output-suffix"}) {
    std::string text = settings.find(option).value_or("");
    for (const auto& [name, value] : values) boost::algorithm::replace_all(text, name, value);
    if (!text.empty()) settings.set(option, text);
  }
}

/// What follows "--" goes to SUMO as it is, so it may not contradict what the run stands on.
void check_for_sumo(const Options& options, const SumoOptions& catalogue) {
  static constexpr std::array<std::string_view, 15> owned{"configuration-file",
                                                          "net-file",
                                                          "route-files",
                                                          "additional-files",
                                                          "begin",
                                                          "scale",
                                                          "seed",
                                                          "random",
                                                          "tripinfo-output",
                                                          "tripinfo-output.write-unfinished",
                                                          "tripinfo-output.write-undeparted",
                                                          "statistic-output",
                                                          "load-state",
                                                          "output-prefix",
                                                          "output-suffix"};
  for (const auto& argument : options.for_sumo()) {
    const auto* option = catalogue.find_argument(argument);
    if (option == nullptr || std::find(owned.begin(), owned.end(), option->first) == owned.end()) continue;
    throw InputError(
        fmt::format("'{}' cannot be given to SUMO alone: write it in the configuration, or before the '--' "
                    "if thalweg has this option",
                    argument));
  }
}

void check_files(const Settings& settings) {
  verify(settings.find("net-file").has_value(),
         "no net-file: name a configuration with -c, or a network with -n (and its demand with -r)");
  for (const char* option : {"net-file", "route-files", "additional-files"}) {
    for (const auto& file : file_list(settings.find(option).value_or(""))) {
      verify(fs::exists(file), fmt::format("the {} '{}' does not exist", option, file));
    }
  }
}

void make_output_folder(const fs::path& folder) {
  for (const auto& [marks, meaning] :
       {std::pair{",;", "for the end of a file's name"}, {":", "for a host's port"}}) {
    verify(folder.string().find_first_of(marks) == std::string::npos,
           fmt::format(
               "the output folder '{}' has one of \"{}\" in its name, which SUMO takes {}: choose another "
               "with --output-folder",
               folder.string(), marks, meaning));
  }
  std::error_code error;
  fs::create_directories(folder, error);
  const fs::path probe = folder / ".thalweg-probe";
  try {
    if (!error) OutputFile(probe).commit();
  } catch (const InputError&) {
    error = std::make_error_code(std::errc::permission_denied);
  }
  if (error)
    throw InputError(fmt::format("cannot write to the folder '{}': {}", folder.string(), error.message()));
  fs::remove(probe);
}

/// duarouter may take minutes; that it was told to end is no fault of the demand.
Demand prepare(const Options& options, const Project& project) {
  Demand demand;
  try {
    demand = prepare_demand(project.settings, project.network, project.sumo, project.demand_files,
                            options.header(), stop_requested);
  } catch (const InputError&) {
    if (!stop_requested) throw;
  }
  verify(!stop_requested, "interrupted while the demand was prepared");
  return demand;
}

/// `left_out`: who it is, and out of what.
std::string told(std::string_view left_out, const std::vector<DroppedVehicle>& dropped,
                 const DemandFiles& files) {
  return fmt::format("{} {}: '{}' ({}){}; see {}", dropped.size(), left_out, dropped.front().id,
                     dropped.front().reason, dropped.size() > 1 ? " .." : "", files.dropped().string());
}

/// What a comparison with SUMO's device must know: for it the road is open.
void tell_open_closings(const Project& project) {
  const auto& changes = project.lane_changes;
  const auto open = std::ranges::find_if(changes, [](const LaneChange& change) { return !change.enforced; });
  if (open == changes.end()) return;
  warn(fmt::format(
      "the closingReroute of '{}' names no classes: SUMO's device.rerouting goes on sending vehicles "
      "through (our routers do not); write disallow=\"all\" to close it for everybody",
      project.network.roads[project.network.lanes[open->lane].road].id));
}

}  // namespace

std::vector<OptionSpec> project_options() {
  std::vector<OptionSpec> specs{
      {"input", "configuration-file", 'c', "FILE", "", "Your .sumocfg, unchanged"},
      {"input", "net-file", 'n', "FILE", "", "The network, instead of the configuration's"},
      {"input", "route-files", 'r', "FILE", "", "The demand, instead of the configuration's"},
      {"input", "additional-files", 'a', "FILE", "", "Additional files, instead of the configuration's"},
      {"input", "prepared", 0, "FILE", "", "Takes the demand that an earlier run prepared in this folder"},
      {"input", "strict", 0, "BOOL", "false", "A vehicle that cannot be routed is an error"},
      {"output", "output-folder", 'o', "FILE", "thalweg-output", "Where every output goes"},
      {"output", "output-prefix", 0, "STR", "", "Is put before the name of SUMO's outputs"},
      {"time", "begin", 'b', "TIME", "0", "Begin of the simulation"},
      {"time", "end", 'e', "TIME", "-1", "End of the simulation; -1: when all have arrived"},
      {"time", "step-length", 0, "TIME", "1", "SUMO's step"},
  };
  const auto routing = routing_options();
  specs.insert(specs.end(), routing.begin(), routing.end());
  return specs;
}

void warn_of_arms(const Project& project, std::span<const ArmSpec> arms) {
  if (std::ranges::any_of(arms, [](const ArmSpec& arm) { return arm.has_device(); }))
    tell_open_closings(project);
  const Settings& settings = project.settings;
  constexpr std::string_view output = "device.rerouting.output";
  const auto no_arm_takes = [&](std::string_view name) {
    return std::ranges::all_of(arms, [&](const ArmSpec& arm) { return is_overruled(name, arm); });
  };
  if (settings.find(output) && no_arm_takes(output))
    warn("device.rerouting.output is not written: only SUMO's own device has it (device, one-shot)");
  for (const Setting& setting : settings.all()) {
    if (setting.name == output || !no_arm_takes(setting.name)) continue;
    warn(
        fmt::format("{} of the configuration does not count, as all device.rerouting.*: each arm has its own "
                    "(SUMO's router with your settings is the arm device:KEY=VALUE)",
                    setting.name));
    break;
  }
  for (const char* option : {"tripinfo-output", "statistic-output", "vehroute-output"}) {
    const auto file = settings.find(option);
    if (file && !file->empty() && !is_readable_output(*file))
      warn(fmt::format("{} '{}' is written as XML under a name of its own: it is read afterwards", option,
                       *file));
  }
}

Project load_project(Options& options, const std::function<void(const SumoOptions&)>& check) {
  Project project;
  project.sumo = find_sumo();
  require_tool(project.sumo.sumo, "sumo");
  prepare_environment(project.sumo);
  const fs::path configuration(options.text("configuration-file"));
  verify(configuration.empty() || fs::exists(configuration),
         fmt::format("the configuration '{}' does not exist", configuration.string()));
  project.catalogue = SumoOptions::ask(project.sumo.sumo);
  check_for_sumo(options, project.catalogue);
  if (!configuration.empty()) {
    for (const Configuration& one : with_named_ones(configuration))
      read_user_configuration(options, project, one);
  }
  apply_command_line(options, project);
  fill_in_time(project.settings);
  check(project.catalogue);
  check_files(project.settings);
  project.name = configuration.empty() ? options.text("net-file") : configuration.string();
  {
    const std::string net = *project.settings.find("net-file");
    const Stage stage(fmt::format("Loading net-file from '{}'", net));
    project.network = read_network(net);
  }
  for (const auto& warning : project.network.warnings) warn(warning);
  project.output = fs::absolute(options.text("output-folder")).lexically_normal();
  make_output_folder(project.output);
  const bool prepared = !options.text("prepared").empty();
  project.demand_files =
      DemandFiles(prepared ? fs::path(options.text("prepared")) : project.output / "demand");
  const Stage stage(prepared ? "Reading the prepared demand" : "Preparing the demand");
  project.demand = prepared ? read_prepared_demand(project.settings, project.network, project.demand_files)
                            : prepare(options, project);
  if (project.demand.vehicles.empty())
    warn("the demand has no vehicles: there is nobody for Thalweg to re-route");
  const auto& lost = project.demand.lost_persons;
  if (!lost.empty()) {
    warn(told("person(s) or container(s) cannot be routed and are left out", lost, project.demand_files));
  }
  const auto& dropped = project.demand.dropped;
  if (!dropped.empty()) {
    const std::string text = told("vehicle(s) or flow(s) cannot be routed and are left out of every arm",
                                  dropped, project.demand_files);
    verify(!options.flag("strict"), text);
    warn(text);
  }
  project.lane_changes =
      read_lane_changes(file_list(project.settings.find("additional-files").value_or("")), project.network);
  return project;
}

}  // namespace thalweg
