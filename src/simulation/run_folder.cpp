// SPDX-License-Identifier: Apache-2.0
#include "simulation/run_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "demand/additional.hpp"
#include "xml/writer.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

/// What a run decides itself or has no use for.
bool is_replaced(const std::string& name) {
  static constexpr std::array<std::string_view, 14> names{"output-suffix",
                                                          "output.format",
                                                          "configuration-file",
                                                          "save-configuration",
                                                          "save-template",
                                                          "save-schema",
                                                          "save-commented",
                                                          "route-files",
                                                          "additional-files",
                                                          "output-prefix",
                                                          "random",
                                                          "seed",
                                                          "scale",
                                                          "remote-port"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Where the user's name for an output that we read is kept; else it has the name `file`.
fs::path readable_output(Settings& run, OutputPlaces& places, std::string_view option,
                         std::string_view file) {
  if (!is_readable_output(run.find(option).value_or("")))
    run.set(option, places.place(file, places.folder()));
  return *run.find(option);
}

/// "device.ssm.file" -> "ssm"
std::string device_of(std::string_view option) {
  option.remove_prefix(std::string_view("device.").size());
  return std::string(option.substr(0, option.find('.')));
}

/// The mean speeds of every road: maps are drawn from them, and the relative gap is computed.
fs::path write_edge_data(const fs::path& folder) {
  fs::path file = folder / "thalweg.add.xml";
  xml::Writer writer(file, "written by thalweg");
  writer.open("additional");
  writer.open("edgeData")
      .attribute("id", "thalweg")
      .attribute("file", "edgedata.xml")
      .attribute("period", "300")
      .attribute("withInternal", "true")
      .attribute("writeAttributes", "traveltime sampledSeconds speed entered left")
      .attribute("excludeEmpty", "true");
  writer.commit();
  return file;
}

}  // namespace

bool is_overruled(std::string_view name, const ArmSpec& arm) {
  return name.starts_with("device.rerouting.") && !(arm.has_device() && name == "device.rerouting.output");
}

bool is_readable_output(std::string_view file) {
  const bool is_xml = file.ends_with(".xml") || file.ends_with(".xml.gz");
  return is_xml && file.find("${") == std::string_view::npos;  // SUMO fills in the time
}

RunFolder make_run_folder(const fs::path& folder, const Settings& user, const SumoOptions& options,
                          const DemandFiles& demand, const ArmSpec& arm, std::uint64_t seed,
                          std::string_view header) {
  const fs::path home = fs::absolute(folder).lexically_normal();
  fs::create_directories(home);
  OutputPlaces places(home, user.find("output-prefix").value_or(""), user.find("output-suffix").value_or(""));
  Settings run;
  for (const auto& [name, value] : user.all()) {
    const auto* option = options.find(name);
    if (is_replaced(name) || is_overruled(name, arm) || option == nullptr) continue;
    run.set(name, SumoOptions::is_output(name, option->second) ? places.place(value, home) : value);
  }
  RunFolder result{.folder = home,
                   .configuration = home / "run.sumocfg",
                   .tripinfo = {},
                   .statistics = {},
                   .routes = {},
                   .edge_data = home / "edgedata.xml",
                   .errors = {}};
  result.tripinfo = readable_output(run, places, "tripinfo-output", "tripinfo.xml");
  result.statistics = readable_output(run, places, "statistic-output", "statistics.xml");
  result.routes = readable_output(run, places, "vehroute-output", "vehroutes.xml");
  for (const auto& name :
       options.names()) {  // else a vehicle's device writes to where the program was started
    const bool names_file = name.starts_with("device.") && name.ends_with(".file");
    if (names_file && !run.find(name)) run.set(name, places.place(device_of(name) + ".xml", home));
  }
  if (!run.find("error-log")) run.set("error-log", places.place("sumo.log", home));
  result.errors = *run.find("error-log");
  // What an earlier run left here must not be read as this one's, should SUMO write elsewhere or not at all.
  for (const fs::path& file : {result.tripinfo, result.statistics, result.routes, result.errors,
                               result.edge_data, home / "run.json"}) {
    std::error_code ignored;
    if (file.is_absolute() && fs::is_regular_file(file, ignored)) fs::remove(file, ignored);
  }
  if (run.find("load-state")) run.set("load-state", fs::absolute(demand.state()).string());
  run.set("tripinfo-output.write-unfinished", "true");
  run.set("tripinfo-output.write-undeparted", "true");
  run.set("no-step-log", "true");
  run.set("ignore-route-errors",
          "true");  // checked by duarouter; what SUMO still drops is counted as discarded
  run.set("seed", std::to_string(seed));
  run.set("route-files", fs::absolute(arm.free_flow_routes ? demand.free_flow() : demand.given()).string());

  std::string additional;
  int number = 0;
  for (const auto& file : file_list(user.find("additional-files").value_or(""))) {
    const fs::path copy = home / fmt::format("additional.{}.xml", number++);
    rewrite_additional(file, copy, places, false);
    additional += copy.string() + ",";
  }
  run.set("additional-files", additional + write_edge_data(home).string());
  for (const auto& [name, value] : arm.settings) run.set(name, value);
  write_configuration(result.configuration, header, run.all());
  return result;
}

}  // namespace thalweg
