// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/messages.hpp"
#include "app/start.hpp"
#include "core/error.hpp"
#include "core/nearest.hpp"
#include "core/number.hpp"
#include "graph/road_graph.hpp"
#include "network/read_network.hpp"
#include "routing/strategy.hpp"
#include "traffic/weight_file.hpp"
#include "xml/node.hpp"

namespace thalweg {
namespace {

Options route_options() {
  const TurnPenalties penalties;
  const auto seconds = [](Millis t) { return fmt::format("{}", to_seconds(t)); };
  return {"route",
          "routes on a network, without SUMO",
          {{"configuration", "configuration-file", 'c', "FILE", "", "Takes options from this file"},
           {"input", "net-file", 'n', "FILE", "", "The network"},
           {"input", "from", 0, "STR", "", "Routes from this road"},
           {"input", "to", 0, "STR", "", "to this road"},
           {"input", "route-files", 'r', "FILE", "", "Routes these trips (with from, to and via)"},
           {"input", "weight-files", 'w', "FILE", "", "Travel times of the roads"},
           {"output", "output-file", 'o', "FILE", "", "The vehicles with their routes"},
           {"output", "write-costs", 0, "BOOL", "false", "Writes the cost of each route [s]"},
           {"time", "begin", 'b', "TIME", "0", "The time whose weights are used"},
           {"routing", "strategy", 0, "STR", "evolved", "hybrid, evolved, cch or dijkstra"},
           {"routing", "vclass", 0, "STR", "passenger", "The vehicle class"},
           {"routing", "weights.minor-penalty", 0, "TIME", seconds(penalties.minor),
            "Penalty for a turn that gives way"},
           {"routing", "weights.turnaround-penalty", 0, "TIME", seconds(penalties.turnaround),
            "Penalty for a turn-around"},
           {"routing", "weights.tls-penalty", 0, "TIME", seconds(penalties.signal),
            "Penalty for a signalled turn"},
           {"processing", "ignore-errors", 0, "BOOL", "false",
            "Leaves out what cannot be routed, with a warning"},
           {"processing", "threads", 0, "INT", "1", "Threads; the result does not depend on them"}}};
}

class Router {
 public:
  explicit Router(const Options& options) : options_(options) {
    const Stage stage(fmt::format("Loading net-file from '{}'", options.text("net-file")));
    network_ = read_network(options.text("net-file"));
    for (const auto& warning : network_.warnings) warn(warning);
    for (const auto& [id, road] : network_.road_ids) road_names_.push_back(id);
    const auto vehicle_class = parse_vehicle_class(options.text("vclass"));
    verify(vehicle_class.has_value(),
           fmt::format("--vclass {}: nobody knows this vehicle class", options.text("vclass")));
    graph_ = std::make_unique<RoadGraph>(network_, *vehicle_class);
    ClassTraffic traffic{.graph = graph_.get(), .free_flow = {}, .road_times = {}, .turn_costs = {}};
    traffic.free_flow = free_flow_times(network_, *vehicle_class, default_max_speed(*vehicle_class),
                                        {.minor = options.time("weights.minor-penalty"),
                                         .turnaround = options.time("weights.turnaround-penalty"),
                                         .signal = options.time("weights.tls-penalty")});
    traffic.road_times = traffic.free_flow;
    for (const auto& file : file_list(options.text("weight-files"))) {
      apply_weight_file(file, network_, options.time("begin"), traffic.road_times);
    }
    turn_costs(*graph_, traffic.road_times, traffic.turn_costs);
    traffic_.push_back(std::move(traffic));
    const auto threads = options.count("threads");
    verify(threads >= 1 && threads <= 256, "--threads must be from 1 to 256");
    strategy_ = make_strategy(options.text("strategy"),
                              {.rule = {.relative = 0, .spread = 0, .absolute = 0}, .threads = threads});
  }

  /// Adds a trip; what is wrong with it is returned, and nothing when it is well.
  std::string add(std::string_view from, std::string_view to, std::string_view via) {
    Traveller traveller;
    std::vector<std::string_view> roads = split(via, " ");
    roads.insert(roads.begin(), from);
    roads.push_back(to);
    for (const auto name : roads) {
      const auto road = network_.find_road(name);
      if (!road)
        return fmt::format("the edge '{}' is not in the net{}", name, did_you_mean(name, road_names_));
      const VertexId vertex = graph_->vertex(*road);
      if (!vertex.valid()) return fmt::format("the edge '{}' is within a junction", name);
      if (!graph_->permitted(vertex)) {
        return fmt::format("the edge '{}' is forbidden for the class '{}'", name, options_.text("vclass"));
      }
      if (traveller.route.empty()) {
        traveller.route.push_back(vertex);
      } else if (vertex !=
                 (traveller.waypoints.empty() ? traveller.route.front() : traveller.waypoints.back())) {
        traveller.waypoints.push_back(vertex);
      }
    }
    travellers_.push_back(std::move(traveller));
    return {};
  }

  void route() { strategy_->decide(traffic_, travellers_, decisions_); }

  /// Of the i-th trip added; nullopt: there is no way.
  [[nodiscard]] std::optional<std::pair<std::string, Millis>> result(std::size_t i) const {
    const Traveller& traveller = travellers_[i];
    if (traveller.waypoints.empty()) {  // from a road to itself
      return std::pair{network_.roads[graph_->road(traveller.route.front())].id,
                       traffic_.front().road_times[graph_->road(traveller.route.front())]};
    }
    if (decisions_[i].route.empty()) return std::nullopt;
    std::string edges;
    for (const VertexId vertex : decisions_[i].route) {
      if (!edges.empty()) edges += ' ';
      edges += network_.roads[graph_->road(vertex)].id;
    }
    return std::pair{std::move(edges), decisions_[i].new_cost};
  }

 private:
  const Options& options_;
  Network network_;
  std::vector<std::string> road_names_;
  std::unique_ptr<RoadGraph> graph_;
  std::vector<ClassTraffic> traffic_;
  std::unique_ptr<Strategy> strategy_;
  std::vector<Traveller> travellers_;
  std::vector<Decision> decisions_;
};

int route_pair(Router& router, const Options& options) {
  const auto problem = router.add(options.text("from"), options.text("to"), "");
  verify(problem.empty(), problem);
  router.route();
  const auto found = router.result(0);
  verify(found.has_value(),
         fmt::format("there is no way from '{}' to '{}'", options.text("from"), options.text("to")));
  fmt::print("{}\ncost {} s\n", found->first, fmt::format("{:.3f}", to_seconds(found->second)));
  return 0;
}

int route_trips(Router& router, const Options& options) {
  verify(!options.text("output-file").empty(), "no output-file: name it with -o");
  std::vector<xml::Node> trips;
  std::vector<xml::Node> others;  // types
  const bool ignore_errors = options.flag("ignore-errors");
  const auto give_up = [&](const xml::Node& node, const std::string& problem) {
    if (!ignore_errors) throw node.error(problem);
    warn(node.error(problem).what());
  };
  for (const auto& file : file_list(options.text("route-files"))) {
    xml::read_nodes(
        file, [](const xml::Element&) {},
        [&](xml::Node& node) {
          if (node.name == "vType" || node.name == "vTypeDistribution") {
            others.push_back(std::move(node));
          } else if (node.name == "trip") {
            const auto problem =
                router.add(node.require("from"), node.require("to"), node.value_or("via", ""));
            if (problem.empty()) {
              trips.push_back(std::move(node));
            } else {
              give_up(node, problem);
            }
          } else {
            give_up(node, "only <trip> is routed here");
          }
        });
  }
  router.route();
  xml::Writer writer(options.text("output-file"), options.header());
  writer.open("routes");
  for (const xml::Node& type : others) write_node(writer, type);
  for (std::size_t i = 0; i < trips.size(); ++i) {
    const auto found = router.result(i);
    if (!found) {
      give_up(trips[i], fmt::format("there is no way from '{}' to '{}'", trips[i].require("from"),
                                    trips[i].require("to")));
      continue;
    }
    writer.open("vehicle");
    for (const auto& [name, value] : trips[i].attributes) {
      if (name != "from" && name != "to" && name != "via") writer.attribute(name, value);
    }
    writer.open("route");
    if (options.flag("write-costs"))
      writer.attribute("cost", fmt::format("{:.3f}", to_seconds(found->second)));
    writer.attribute("edges", found->first).close();
    for (const xml::Node& child : trips[i].children) write_node(writer, child);
    writer.close();
  }
  writer.commit();
  return 0;
}

}  // namespace

int route_command(std::span<const std::string> arguments) {
  Options options = route_options();
  if (!start(options, arguments, OwnConfiguration::yes)) return 0;
  verify(!options.text("net-file").empty(), "no net-file: name it with -n");
  const bool pair = !options.text("from").empty() && !options.text("to").empty();
  verify(pair || !options.text("route-files").empty(),
         "what to route? Give --from and --to, or trips with -r");
  Router router(options);
  return pair ? route_pair(router, options) : route_trips(router, options);
}

}  // namespace thalweg
