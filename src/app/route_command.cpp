// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/commands.hpp"
#include "app/messages.hpp"
#include "app/order_cache_option.hpp"
#include "app/routing_options.hpp"
#include "app/start.hpp"
#include "core/error.hpp"
#include "core/number.hpp"
#include "demand/flow.hpp"
#include "demand/vehicle_types.hpp"
#include "network/read_network.hpp"
#include "network/zones.hpp"
#include "routing/trip_router.hpp"
#include "xml/node.hpp"

namespace thalweg {
namespace {

Options route_options() {
  std::vector<OptionSpec> specs{
      {"configuration", "configuration-file", 'c', "FILE", "", "Takes options from this file"},
      {"input", "net-file", 'n', "FILE", "", "The network"},
      {"input", "from", 0, "STR", "", "Routes from this road"},
      {"input", "to", 0, "STR", "", "to this road"},
      {"input", "route-files", 'r', "FILE", "", "Routes these trips and flows; vehicles keep their routes"},
      {"input", "additional-files", 'a', "FILE", "", "Vehicle types and zones are read from these"},
      {"input", "weight-files", 'w', "FILE", "", "Travel times of the roads"},
      {"output", "output-file", 'o', "FILE", "", "The vehicles with their routes"},
      {"output", "write-costs", 0, "BOOL", "false", "Writes the cost of each route [s]"},
      {"time", "begin", 'b', "TIME", "0", "The time whose weights are used"},
      {"routing", "strategy", 0, "STR", "cch", "hybrid, evolved, cch or dijkstra"},
      {"routing", "vclass", 0, "STR", "passenger", "The class of trips without a type"},
      {"random", "seed", 0, "INT", "23423", "What flows with random departures are drawn by"},
      {"processing", "ignore-errors", 0, "BOOL", "false", "Leaves out what cannot be routed, with a warning"},
      no_cache_option(),
      threads_option()};
  for (auto& spec : penalty_options()) specs.push_back(std::move(spec));
  return {"route", "routes on a network, without SUMO", std::move(specs)};
}

std::unique_ptr<TripRouter> make_router(const Network& network, const Options& options) {
  for (const auto& entry : strategies()) {
    verify(entry.name != options.text("strategy") || !entry.needs_simulation,
           fmt::format("--strategy {}: it watches a simulation and is for 'thalweg run'", entry.name));
  }
  auto strategy =
      make_strategy(options.text("strategy"), {.rule = {.relative = 0, .spread = 0, .absolute = 0},
                                               .threads = thread_count(options),
                                               .order_cache = order_cache(options)});
  return std::make_unique<TripRouter>(
      network,
      TripRouter::Setting{.penalties = turn_penalties(options),
                          .weight_files = file_list(options.text("weight-files")),
                          .time = options.time("begin")},
      std::move(strategy));
}

/// What drives when no type says otherwise.
DrivenType typeless(const Options& options) {
  const auto vehicle_class = parse_vehicle_class(options.text("vclass"));
  verify(vehicle_class.has_value(),
         fmt::format("--vclass {}: nobody knows this vehicle class", options.text("vclass")));
  return {.id = {}, .vehicle_class = *vehicle_class, .max_speed = default_max_speed(*vehicle_class)};
}

int route_pair(TripRouter& router, const Options& options) {
  const std::array<std::string_view, 2> ends{options.text("from"), options.text("to")};
  const DrivenType type = typeless(options);
  const auto problem = router.add(type.vehicle_class, type.max_speed, ends);
  verify(problem.empty(), problem);
  router.route();
  const auto found = router.result(0);
  verify(found.has_value(), fmt::format("there is no way from '{}' to '{}'", ends[0], ends[1]));
  fmt::print("{}\ncost {} s\n", found->edges, fmt::format("{:.3f}", to_seconds(found->cost)));
  return 0;
}

/// A demand file by file: read, routed as one batch, written in the order of departure.
class DemandRoute {
 public:
  DemandRoute(TripRouter& router, const Options& options)
      : router_(router),
        options_(options),
        typeless_(typeless(options)),
        ignore_errors_(options.flag("ignore-errors")),
        seed_(options.count("seed")) {}

  void read_types(const std::filesystem::path& file) {
    xml::read_nodes_and_included(file, [&](const xml::Node& node, const std::filesystem::path&) {
      if (is_type(node)) types_.add(node);
    });
  }

  void read(const std::filesystem::path& file) {
    xml::read_nodes_and_included(file, [&](xml::Node& node, const std::filesystem::path&) {
      if (is_type(node) || node.name == "route" || node.name == "routeDistribution") {
        if (is_type(node)) types_.add(node);
        definitions_.push_back(std::move(node));
      } else if (node.name == "flow") {
        guarded([&] {
          for (xml::Node& one : expand_flow(node, seed_)) take(std::move(one));
        });
      } else if (node.name == "trip" || node.name == "vehicle") {
        guarded([&] { take(std::move(node)); });
      } else if (is_walking(node.name) && !needs_routing(node)) {
        vehicles_.push_back({.node = std::move(node), .depart = 0, .trip = std::nullopt});
        vehicles_.back().depart = depart_of(vehicles_.back().node);
      } else {
        give_up(node, "only vehicles, trips and flows of them are routed here: let duarouter do this");
      }
    });
  }

  void route() {
    const Stage stage(fmt::format("Routing {} trips", trips_));
    router_.route();
  }

  void write(const std::filesystem::path& file) {
    std::stable_sort(vehicles_.begin(), vehicles_.end(),
                     [](const Vehicle& a, const Vehicle& b) { return a.depart < b.depart; });
    xml::Writer writer(file, options_.header());
    writer.open("routes");
    for (const xml::Node& definition : definitions_) write_node(writer, definition);
    for (const Vehicle& vehicle : vehicles_) write_vehicle(writer, vehicle);
    writer.commit();
    if (left_out_ > 0) warn(fmt::format("{} left out: what is wrong with each is told above", left_out_));
  }

 private:
  struct Vehicle {
    xml::Node node;
    Millis depart = 0;
    std::optional<std::size_t> trip;  ///< number in the router; nothing: it brings its route
  };

  static bool is_type(const xml::Node& node) {
    return node.name == "vType" || node.name == "vTypeDistribution";
  }

  static bool is_walking(std::string_view element) {
    return element == "person" || element == "personFlow" || element == "container" ||
           element == "containerFlow";
  }

  /// Some stage of the plan is not there yet, or is of a kind that is not known here.
  static bool needs_routing(const xml::Node& person) {
    return !std::all_of(person.children.begin(), person.children.end(), [](const xml::Node& stage) {
      if (stage.name != "walk" && stage.name != "tranship")
        return stage.name == "ride" || stage.name == "transport" || stage.name == "stop" ||
               stage.name == "param";
      return stage.find("edges") != nullptr || stage.find("route") != nullptr;
    });
  }

  /// "triggered" and the like come first.
  static Millis depart_of(const xml::Node& node) {
    return parse_time(node.value_or("depart", node.value_or("begin", ""))).value_or(0);
  }

  void give_up(const xml::Node& node, const std::string& problem) {
    guarded([&] { throw node.error(problem); });
  }

  /// What is wrong with one of them ends it all, or is told and leaves that one out (--ignore-errors).
  template <class Work>
  void guarded(Work work) {
    try {
      work();
    } catch (const InputError& error) {
      if (!ignore_errors_) throw;
      warn(error.what());
      ++left_out_;
    }
  }

  void take(xml::Node node) {
    const bool has_route =
        std::any_of(node.children.begin(), node.children.end(),
                    [](const xml::Node& child) { return child.name.starts_with("route"); });
    Vehicle vehicle{.node = std::move(node), .depart = 0, .trip = std::nullopt};
    vehicle.depart = depart_of(vehicle.node);
    if (!has_route && vehicle.node.find("route") == nullptr) {
      const auto problem = add_trip(vehicle.node);
      if (!problem.empty()) return give_up(vehicle.node, problem);
      vehicle.trip = trips_++;
    }
    vehicles_.push_back(std::move(vehicle));
  }

  /// A road, or what stands for a zone; where both are named the road counts, as for duarouter.
  static std::string end_of(const xml::Node& node, std::string_view road, std::string_view zone,
                            std::string (*road_of)(std::string_view)) {
    const bool is_zone = node.find(road) == nullptr && node.find(zone) != nullptr;
    return is_zone ? road_of(node.require(zone)) : node.require(road);
  }

  /// What is wrong with it; the type of a distribution is put in its place.
  std::string add_trip(xml::Node& node) {
    DrivenType type = typeless_;
    if (const std::string* name = node.find("type")) {
      const DrivenType* known = types_.find(*name, node.value_or("id", ""));
      if (known == nullptr) return fmt::format("the vehicle type '{}' is not known", *name);
      type = *known;
      node.set("type", type.id);
    }
    const std::string from = end_of(node, "from", "fromTaz", zone_source);
    const std::string to = end_of(node, "to", "toTaz", zone_sink);
    std::vector<std::string_view> roads{from};
    for (const auto via : split(node.value_or("via", ""), " ,")) roads.push_back(via);
    for (const xml::Node& child : node.children) {
      if (child.name != "stop") continue;
      if (child.find("edge") == nullptr && child.find("lane") == nullptr) {
        return "a stop at a stopping place: let duarouter do this";
      }
      std::string_view road = child.value_or("edge", child.value_or("lane", ""));
      if (child.find("edge") == nullptr) road = road.substr(0, road.rfind('_'));
      if (std::find(roads.begin(), roads.end(), road) == roads.end()) roads.push_back(road);
    }
    roads.emplace_back(to);
    std::string problem = router_.add(type.vehicle_class, type.max_speed, roads);
    const bool has_zone = node.find("fromTaz") != nullptr || node.find("toTaz") != nullptr;
    if (!problem.empty() && has_zone) problem += "; zones are read from additional-files";
    return problem;
  }

  void write_vehicle(xml::Writer& writer, const Vehicle& vehicle) {
    const xml::Node& node = vehicle.node;
    if (!vehicle.trip) return write_node(writer, node);
    const auto found = router_.result(*vehicle.trip);
    if (!found) {
      return give_up(
          node, fmt::format("there is no way from '{}' to '{}'", end_of(node, "from", "fromTaz", zone_source),
                            end_of(node, "to", "toTaz", zone_sink)));
    }
    writer.open("vehicle");
    for (const auto& [name, value] : node.attributes) {
      if (name != "from" && name != "to" && name != "via") writer.attribute(name, value);
    }
    writer.open("route");
    if (options_.flag("write-costs"))
      writer.attribute("cost", fmt::format("{:.3f}", to_seconds(found->cost)));
    writer.attribute("edges", found->edges).close();
    for (const xml::Node& child : node.children) write_node(writer, child);
    writer.close();
  }

  TripRouter& router_;
  const Options& options_;
  DrivenType typeless_;
  bool ignore_errors_;
  std::uint64_t seed_;
  std::size_t left_out_ = 0;
  VehicleTypes types_;
  std::vector<xml::Node> definitions_;  ///< types and named routes, as they came
  std::vector<Vehicle> vehicles_;
  std::size_t trips_ = 0;
};

int route_demand(TripRouter& router, const Options& options) {
  verify(!options.text("output-file").empty(), "no output-file: name it with -o");
  DemandRoute demand(router, options);
  for (const auto& file : file_list(options.text("additional-files"))) demand.read_types(file);
  for (const auto& file : file_list(options.text("route-files"))) demand.read(file);
  demand.route();
  demand.write(options.text("output-file"));
  return 0;
}

Network load_network(const Options& options) {
  const Stage stage(fmt::format("Loading net-file from '{}'", options.text("net-file")));
  Network network = read_network(options.text("net-file"));
  for (const auto& warning : network.warnings) warn(warning);
  for (const auto& file : file_list(options.text("additional-files"))) add_zones(file, network);
  return network;
}

}  // namespace

int route_command(std::span<const std::string> arguments) {
  Options options = route_options();
  if (!start(options, arguments, OwnConfiguration::yes)) return 0;
  verify(!options.text("net-file").empty(), "no net-file: name it with -n");
  const bool pair = !options.text("from").empty() && !options.text("to").empty();
  verify(pair || !options.text("route-files").empty(),
         "what to route? Give --from and --to, or trips with -r");
  const Network network = load_network(options);
  const auto router = make_router(network, options);
  return pair ? route_pair(*router, options) : route_demand(*router, options);
}

}  // namespace thalweg
