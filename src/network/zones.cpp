// SPDX-License-Identifier: Apache-2.0
#include "network/zones.hpp"

#include <fmt/format.h>

#include "core/number.hpp"
#include "xml/node.hpp"

namespace thalweg {
namespace {

RoadId add_pseudo_road(const xml::Node& zone, std::string id, Network& network) {
  const RoadId road = network.roads.next_id();
  if (!network.road_ids.try_emplace(id, road).second) {
    throw zone.error(fmt::format("there is an edge '{}' already", id));
  }
  const LaneId lane = network.lanes.push_back({.road = road, .length = 0, .speed = 1, .shape = {}});
  network.roads.push_back({.id = std::move(id),
                           .function = RoadFunction::zone,
                           .from = {},
                           .to = {},
                           .type = {},
                           .name = {},
                           .priority = 0,
                           .first_lane = lane,
                           .lane_count = 1,
                           .shape = {}});
  return road;
}

class ZoneReader {
 public:
  ZoneReader(const xml::Node& zone, Network& network)
      : zone_(zone),
        network_(network),
        source_(add_pseudo_road(zone, zone_source(zone.require("id")), network)),
        sink_(add_pseudo_road(zone, zone_sink(zone.require("id")), network)) {}

  void read() {
    for (const auto road : split(zone_.value_or("edges", ""), " \t\r\n")) {
      add_source(known(zone_, road));
      add_sink(known(zone_, road));
    }
    for (const xml::Node& child : zone_.children) {
      if (child.name == "tazSource") add_source(known(child, child.require("id")));
      if (child.name == "tazSink") add_sink(known(child, child.require("id")));
    }
  }

 private:
  [[nodiscard]] RoadId known(const xml::Node& node, std::string_view name) const {
    const auto road = network_.find_road(name);
    if (!road) throw node.error(fmt::format("the edge '{}' is not in the net", name));
    return *road;
  }

  /// By every lane: which of them a class may use is the lane's to say.
  void add_source(RoadId road) {
    for (std::uint32_t lane = 0; lane < network_.roads[road].lane_count; ++lane) {
      network_.connections.push_back({.from = source_, .to = road, .from_lane = 0, .to_lane = lane});
    }
  }
  void add_sink(RoadId road) {
    for (std::uint32_t lane = 0; lane < network_.roads[road].lane_count; ++lane) {
      network_.connections.push_back({.from = road, .to = sink_, .from_lane = lane, .to_lane = 0});
    }
  }

  const xml::Node& zone_;
  Network& network_;
  RoadId source_;
  RoadId sink_;
};

}  // namespace

std::string zone_source(std::string_view zone) { return fmt::format("{}-source", zone); }
std::string zone_sink(std::string_view zone) { return fmt::format("{}-sink", zone); }

void add_zones(const std::filesystem::path& additional_file, Network& network) {
  xml::read_nodes_and_included(additional_file, [&](const xml::Node& node, const std::filesystem::path&) {
    if (node.name == "taz") ZoneReader(node, network).read();
  });
}

}  // namespace thalweg
