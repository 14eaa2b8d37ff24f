// SPDX-License-Identifier: Apache-2.0
#include "demand/prepare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>

#include "core/number.hpp"
#include "core/time.hpp"
#include "demand/additional.hpp"
#include "demand/duarouter.hpp"
#include "demand/duarouter_log.hpp"
#include "demand/input_scan.hpp"
#include "demand/state_file.hpp"
#include "demand/vehicle_file.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

bool by_id(const DroppedVehicle& a, const DroppedVehicle& b) { return a.id < b.id; }

/// The flow that a vehicle or a person came from: "flow.3".
std::string flow_of(const std::string& id) { return id.substr(0, id.rfind('.')); }

/// Of all but those that have these ids as their `own`.
std::unordered_set<std::string> flows_of(const std::unordered_set<std::string>& ids,
                                         const std::unordered_set<std::string>& own) {
  std::unordered_set<std::string> flows;
  for (const auto& id : ids) {
    if (!own.contains(id)) flows.insert(flow_of(id));
  }
  return flows;
}

/// The way points of a vehicle: its own, or those of the flow it came from.
std::string via_of(const std::string& id, const InputScan& scan) {
  const bool is_own = scan.seen.contains(id);
  const auto& vias = is_own ? scan.via : scan.via_of_flows;
  const auto found = vias.find(is_own ? id : flow_of(id));
  return found == vias.end() ? std::string() : found->second;
}

/// The arms' file of vehicles: types in front (without those of additional files, which SUMO reads itself),
/// what duarouter dropped on the way noted in `demand`. Returns the persons and containers among them.
std::unordered_set<std::string> write_given(const fs::path& routed, const fs::path& types_file,
                                            const TypeClasses& other_types, const InputScan& scan,
                                            const Network& network, const DemandFiles& files,
                                            std::string_view header, Demand& demand) {
  TypeClasses types = other_types;
  types.merge(default_types());
  read_types(types_file, types);
  xml::Writer writer(files.given(), fmt::format("the same demand for every arm; {}", header));
  writer.open("routes");
  xml::read_nodes(
      types_file, [](const xml::Element&) {},
      [&](xml::Node& node) {
        if (const std::string* id = node.find("id"); id != nullptr && other_types.contains(*id)) return;
        strip_parameters(node);
        write_node(writer, node);
      });
  std::unordered_set<std::string> persons;
  xml::read_nodes(
      routed, [](const xml::Element&) {},
      [&](xml::Node& node) {
        strip_parameters(node);
        if (node.name.starts_with("person") || node.name.starts_with("container"))
          persons.insert(node.require("id"));
        if (node.name != "vehicle") return write_node(writer, node);
        const std::string& id = node.require("id");
        const auto type = node.value_or("type", "DEFAULT_VEHTYPE");
        if (!types.contains(std::string(type))) {
          demand.dropped.push_back(
              {.id = id, .reason = fmt::format("the vehicle type '{}' is not defined", type)});
          return;
        }
        if (auto via = via_of(id, scan); !via.empty()) node.set("via", std::move(via));
        DemandVehicle vehicle = describe_vehicle(node, network, types);
        if (vehicle.fixed) {  // not even SUMO's own router touches it
          node.children.push_back({.name = "param",
                                   .attributes = {{"key", "has.rerouting.device"}, {"value", "false"}},
                                   .children = {},
                                   .place = node.place});
        }
        demand.vehicles.push_back(std::move(vehicle));
        write_node(writer, node);
      });
  writer.commit();
  return persons;
}

/// Those that duarouter has said something of, and that it has not written.
void note_lost_persons(const std::string& log, const std::unordered_set<std::string>& written,
                       Demand& demand) {
  const auto flows = flows_of(written, {});
  for (const auto& [id, reason] : reasons_of_persons(log)) {
    if (!written.contains(id) && !flows.contains(id))
      demand.lost_persons.push_back({.id = id, .reason = reason});
  }
  std::sort(demand.lost_persons.begin(), demand.lost_persons.end(), by_id);
}

/// The flows without a single vehicle that duarouter has said something of; the others have none to come.
void note_lost_flows(const InputScan& scan, const std::unordered_set<std::string>& present,
                     const std::unordered_map<std::string, std::string>& reasons, Demand& demand) {
  const auto alive = flows_of(present, scan.seen);
  for (const auto& id : scan.flows) {
    const auto reason = reasons.find(id);
    if (reason == reasons.end() || alive.contains(id)) continue;
    demand.dropped.push_back({.id = id, .reason = "the whole flow: " + reason->second});
  }
}

/// Adds those who were in the input and are not in the output; in a thinned demand only those with a reason.
void note_unrouted(const InputScan& scan, const std::string& log, bool is_thinned, Demand& demand) {
  std::unordered_set<std::string> present;
  for (const DemandVehicle& vehicle : demand.vehicles) present.insert(vehicle.id);
  for (const DroppedVehicle& vehicle : demand.dropped) present.insert(vehicle.id);
  auto reasons = reasons_of(log);
  for (const auto& id : scan.ids) {
    if (present.contains(id)) continue;
    const auto reason = reasons.find(id);
    if (is_thinned && reason == reasons.end()) continue;
    demand.dropped.push_back(
        {.id = id, .reason = reason == reasons.end() ? "duarouter left it out" : reason->second});
    reasons.erase(id);
  }
  note_lost_flows(scan, present, reasons, demand);
  std::vector<DroppedVehicle> of_flows;
  for (const auto& [id, reason] : reasons) {
    if (!present.contains(id) && !scan.seen.contains(id) && !scan.seen_flows.contains(id))
      of_flows.push_back({.id = id, .reason = reason});
  }
  std::sort(of_flows.begin(), of_flows.end(), by_id);
  demand.dropped.insert(demand.dropped.end(), of_flows.begin(), of_flows.end());
}

/// The given file with free-flow routes in place of the given ones. Who has no other way keeps his.
void write_free_flow(const Duarouter& duarouter, const DemandFiles& files, std::string_view header,
                     const Demand& demand) {
  const fs::path trips = files.folder / "static.trips.xml";
  const fs::path routed = files.folder / "static.routed.xml";
  std::unordered_set<std::string> fixed;
  for (const DemandVehicle& vehicle : demand.vehicles) {
    if (vehicle.fixed) fixed.insert(vehicle.id);
  }
  {
    xml::Writer writer(trips, "the given vehicles as trips");
    writer.open("routes");
    xml::read_nodes(
        files.given(), [](const xml::Element&) {},
        [&](xml::Node& node) {
          const auto id = node.value_or("id", "");
          const std::string edges = route_edges(node);
          const auto roads = split(edges, " ");
          if (node.name == "vehicle" && !roads.empty() && !fixed.contains(std::string(id))) {
            node.name = "trip";
            std::erase_if(node.children, [](const xml::Node& child) { return child.name == "route"; });
            node.set("from", std::string(roads.front()));
            node.set("to", std::string(roads.back()));
            write_node(writer, node);
          } else if (node.name == "vType" || node.name == "vTypeDistribution") {
            write_node(writer, node);
          }
        });
    writer.commit();
  }
  duarouter.route(trips.string(), routed, {});
  const RoutesById routes = read_routes(routed);
  xml::Writer writer(files.free_flow(),
                     fmt::format("the same demand, every route the fastest on empty roads; {}", header));
  writer.open("routes");
  xml::read_nodes(
      files.given(), [](const xml::Element&) {},
      [&](xml::Node& node) {
        const auto route = routes.find(std::string(node.value_or("id", "")));
        if (node.name == "vehicle" && route != routes.end() && !route->second.empty()) {
          for (xml::Node& child : node.children) {
            if (child.name == "route") child.set("edges", route->second);
          }
        }
        write_node(writer, node);
      });
  writer.commit();
  fs::remove(trips);
  fs::remove(routed);
}

/// The user's settings as duarouter shall have them: the demand of additional files is among the route files
/// by now. The additional files' copies are written to `scratch`.
Settings for_duarouter(const Settings& settings, const fs::path& scratch) {
  fs::create_directories(scratch);
  OutputPlaces places(scratch);
  std::string copies;
  int number = 0;
  for (const auto& file : file_list(settings.find("additional-files").value_or(""))) {
    const fs::path copy = scratch / fmt::format("additional.{}.xml", number++);
    rewrite_additional(file, copy, places, true);
    copies += (copies.empty() ? "" : ",") + copy.string();
  }
  Settings rest = settings;
  rest.set("additional-files", copies);
  if (rest.find("load-state")) rest.erase("begin");  // who is on the road in the state departed before
  return rest;
}

/// InputError: there is nobody to simulate.
void verify_vehicles(const InputScan& scan) {
  verify(!scan.seen.empty() || !scan.seen_flows.empty(),
         "the configuration has no demand: no vehicle, trip, flow, person, container or calibrator in its "
         "files");
  verify(!scan.ids.empty() || !scan.flows.empty() || !scan.dropped.empty(),
         fmt::format("nothing is left of the demand: all departs before the begin ({} s)",
                     format_seconds(scan.begin)));
}

/// A file of no demand: duarouter must have one.
std::string write_nothing(const fs::path& file) {
  xml::Writer writer(file, "no demand");
  writer.open("routes");
  writer.commit();
  return file.string();
}

void write_dropped(const DemandFiles& files, std::string_view header, const Demand& demand) {
  xml::Writer writer(files.dropped(), fmt::format("vehicles left out of every arm, and why; {}", header));
  writer.open("dropped");
  for (const auto& [id, reason] : demand.dropped) {
    writer.open("vehicle").attribute("id", id).attribute("reason", reason).close();
  }
  for (const auto& [id, reason] : demand.lost_persons) {
    writer.open("person").attribute("id", id).attribute("reason", reason).close();
  }
  writer.commit();
}

}  // namespace

Demand prepare_demand(const Settings& settings, const Network& network, const SumoInstallation& sumo,
                      const DemandFiles& files, std::string_view header, const std::atomic<bool>& stop) {
  fs::create_directories(files.folder);
  const fs::path scratch = files.folder / "additional";
  Settings routing = for_duarouter(settings, scratch);
  InputScan scan;
  scan.begin = parse_time(routing.find("begin").value_or("0")).value_or(0);
  scan.end = parse_time(routing.find("end").value_or("-1")).value_or(-1);
  TypeClasses other_types;  // of additional files
  std::string inputs;
  int number = 0;
  const auto scan_all = [&](std::string_view option, bool is_additional) {
    for (const auto& file : file_list(settings.find(option).value_or(""))) {
      const fs::path copy = files.folder / fmt::format("input.{}.xml", number++);
      if (is_additional) read_types(file, other_types);
      if (!scan_demand(file, copy, network, is_additional, scan)) continue;
      inputs += (inputs.empty() ? "" : ",") + copy.string();
    }
  };
  scan_all("additional-files", true);
  scan_all("route-files", false);
  const auto state = settings.find("load-state");
  const bool has_others = scan.has_others || state;
  if (!has_others) verify_vehicles(scan);
  if (inputs.empty()) inputs = write_nothing(files.folder / fmt::format("input.{}.xml", number++));

  Demand demand;
  const fs::path routed = files.folder / "routed.xml";
  const fs::path types = files.folder / "types.xml";
  const std::string log =
      Duarouter(routing, sumo, files.folder, stop).route(inputs, routed, {"--vtype-output", types.string()});
  demand.dropped = scan.dropped;
  const auto persons = write_given(routed, types, other_types, scan, network, files, header, demand);
  note_lost_persons(log, persons, demand);
  const auto scale = parse_number(settings.find("scale").value_or("1"));
  note_unrouted(scan, log, scale && *scale < 1, demand);
  if (scan.has_given_routes) {
    routing.erase("scale");  // done already
    write_free_flow(Duarouter(routing, sumo, files.folder, stop), files, header, demand);
  } else {
    fs::copy_file(files.given(), files.free_flow(), fs::copy_options::overwrite_existing);
  }
  if (state) copy_state_without_flows(*state, files.state(), header);
  fs::remove_all(scratch);
  write_dropped(files, header, demand);
  verify(!demand.vehicles.empty() || (has_others && demand.dropped.empty()),
         fmt::format("nothing is left of the demand: no vehicle can be routed; {} tells why",
                     files.dropped().string()));
  for (int i = 0; i < number; ++i) fs::remove(files.folder / fmt::format("input.{}.xml", i));
  fs::remove(routed);
  fs::remove(types);
  return demand;
}

Demand read_prepared_demand(const Settings& settings, const Network& network, const DemandFiles& files) {
  Demand demand;
  TypeClasses types = default_types();
  for (const auto& file : file_list(settings.find("additional-files").value_or(""))) read_types(file, types);
  read_vehicles(files.given(), network, types, demand);
  xml::read_nodes(
      files.dropped(), [](const xml::Element&) {},
      [&](const xml::Node& node) {
        auto& list = node.name == "person" ? demand.lost_persons : demand.dropped;
        list.push_back({.id = node.require("id"), .reason = std::string(node.value_or("reason", ""))});
      });
  return demand;
}

}  // namespace thalweg
