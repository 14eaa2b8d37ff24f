// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "app/commands.hpp"
#include "app/messages.hpp"
#include "app/start.hpp"
#include "core/error.hpp"
#include "graph/road_graph.hpp"
#include "network/read_network.hpp"
#include "search/instance.hpp"
#include "search/regions.hpp"

namespace thalweg {
namespace {

const char* name_of(InstanceType type) {
  switch (type) {
    case InstanceType::mixed:
      return "mixed";
    case InstanceType::simple:
      return "simple";
    case InstanceType::directed:
      return "directed";
  }
  return "";
}

void print_network(const Network& net) {
  const auto count = [&](RoadFunction function) {
    return std::count_if(net.roads.begin(), net.roads.end(),
                         [&](const Road& r) { return r.function == function; });
  };
  const auto lanes = std::count_if(net.lanes.begin(), net.lanes.end(), [&](const Lane& lane) {
    return net.roads[lane.road].function == RoadFunction::normal;
  });
  const auto connections =
      std::count_if(net.connections.begin(), net.connections.end(),
                    [&](const Connection& c) { return net.roads[c.from].function == RoadFunction::normal; });
  fmt::print("roads {}\nlanes {}\njunctions {}\nconnections {}\nsignals {}\nroundabouts {}\n",
             count(RoadFunction::normal), lanes, net.junctions.size(), connections, net.signals.size(),
             net.roundabouts.size());
  fmt::print("internal roads {}, crossings {}, walking areas {}\n", count(RoadFunction::internal),
             count(RoadFunction::crossing), count(RoadFunction::walking_area));
}

/// The graph as the class drives it: the paper's instance type, its regions from the first road of the
/// largest strongly connected part, and what cannot be reached from there.
void print_graph(const Network& net, VehicleClass vehicle_class) {
  const RoadGraph graph(net, vehicle_class);
  const Digraph& turns = graph.turns();
  std::size_t permitted = 0;
  for (std::size_t v = 0; v < turns.vertex_count(); ++v) permitted += graph.permitted(VertexId{v}) ? 1 : 0;
  const Components parts = strong_components(turns);
  std::vector<std::size_t> sizes(parts.count, 0);
  std::vector<VertexId> first(parts.count);
  for (std::size_t v = 0; v < turns.vertex_count(); ++v) {
    if (!graph.permitted(VertexId{v})) continue;
    const auto part = parts.number[VertexId{v}];
    if (sizes[part]++ == 0) first[part] = VertexId{v};
  }
  const auto part_count = std::count_if(sizes.begin(), sizes.end(), [](std::size_t s) { return s > 0; });
  fmt::print("{}: {} roads, {} turns, instance type {}, {} strongly connected parts", name_of(vehicle_class),
             permitted, graph.turn_count(), name_of(instance_type(turns)), part_count);
  if (permitted == 0) {
    fmt::print("\n");
    return;
  }
  const auto largest = static_cast<std::size_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  Regions regions;
  partition<Direction::forward>(turns, {&first[largest], 1}, regions);
  const std::size_t reached = regions.order.size();
  fmt::print(" (the largest: {} roads), {} regions from '{}', {} roads cannot be reached\n", sizes[largest],
             regions.count(), net.roads[graph.road(first[largest])].id, permitted - reached);
}

}  // namespace

int network_command(std::span<const std::string> arguments) {
  Options options("network", "what a network looks like to the router",
                  {{"configuration", "configuration-file", 'c', "FILE", "", "Takes options from this file"},
                   {"input", "net-file", 'n', "FILE", "", "The network"},
                   {"routing", "vclass", 0, "STR", "passenger", "Vehicle classes, by comma"}});
  if (!start(options, arguments, OwnConfiguration::yes)) return 0;
  verify(!options.text("net-file").empty(), "no net-file: name it with -n");
  const Network net = [&] {
    const Stage stage(fmt::format("Loading net-file from '{}'", options.text("net-file")));
    return read_network(options.text("net-file"));
  }();
  for (const auto& warning : net.warnings) warn(warning);
  print_network(net);
  for (const auto& name : file_list(options.text("vclass"))) {
    const auto vehicle_class = parse_vehicle_class(name);
    verify(vehicle_class.has_value(), fmt::format("--vclass {}: nobody knows this vehicle class", name));
    print_graph(net, *vehicle_class);
  }
  return 0;
}

}  // namespace thalweg
