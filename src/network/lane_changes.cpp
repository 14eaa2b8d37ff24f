// SPDX-License-Identifier: Apache-2.0
#include "network/lane_changes.hpp"

#include <filesystem>

#include "core/number.hpp"
#include "xml/node.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

Millis time_of(const xml::Node& node, std::string_view attribute, Millis otherwise) {
  const std::string* text = node.find(attribute);
  return text == nullptr ? otherwise : parse_time(*text).value_or(otherwise);
}

class Reader {
 public:
  explicit Reader(const Network& network) : network_(network) {}

  void read(const fs::path& file) {
    xml::read_nodes_and_included(file, [&](const xml::Node& node, const fs::path& of) {
      if (node.name == "rerouter") rerouter(node, of.parent_path());
      if (node.name == "variableSpeedSign") speed_sign(node, of.parent_path());
    });
  }

  std::vector<LaneChange> changes;

 private:
  void rerouter(const xml::Node& rerouter, const fs::path& folder) {
    if (rerouter.value_or("off", "false") == "true" || !rerouter.value_or("vTypes", "").empty()) return;
    const auto each = [&](const xml::Node& child) {
      if (child.name == "interval") interval(child);
    };
    for_children(rerouter, folder, each);
  }

  void interval(const xml::Node& interval) {
    for (const xml::Node& child : interval.children) {
      const bool is_road = child.name == "closingReroute";
      if (!is_road && child.name != "closingLaneReroute") continue;
      LaneChange change{
          .lane = {},
          .begin = time_of(interval, "begin", 0),
          .end = time_of(interval, "end", infinity),
          .permissions = allowed(child),
          .enforced = !is_road || child.find("allow") != nullptr || child.find("disallow") != nullptr};
      const std::string& id = child.require("id");
      if (!is_road) {
        add(id, change);
      } else if (const auto road = network_.find_road(id)) {
        for (const LaneId lane : network_.roads[*road].lanes()) {
          change.lane = lane;
          changes.push_back(change);
        }
      }
    }
  }

  void speed_sign(const xml::Node& sign, const fs::path& folder) {
    std::vector<LaneChange> steps;
    for_children(sign, folder, [&](const xml::Node& step) {
      if (step.name != "step") return;
      const Millis begin = time_of(step, "time", 0);
      if (!steps.empty()) steps.back().end = begin;
      const auto speed = parse_number(step.value_or("speed", ""));
      steps.push_back({.lane = {}, .begin = begin, .speed = speed && *speed >= 0 ? speed : std::nullopt});
    });
    for (const auto lane : split(sign.value_or("lanes", ""), " \t\r\n")) {
      for (const LaneChange& step : steps) {
        if (step.speed) add(lane, step);
      }
    }
  }

  /// Its own children, or those of the file that it names.
  template <class Each>
  static void for_children(const xml::Node& node, const fs::path& folder, const Each& each) {
    const std::string* file = node.find("file");
    if (file != nullptr && !file->empty()) xml::read_nodes(folder / *file, each);
    for (const xml::Node& child : node.children) each(child);
  }

  static Permissions allowed(const xml::Node& closing) {
    const auto view = [&](std::string_view attribute) -> std::optional<std::string_view> {
      const std::string* text = closing.find(attribute);
      return text == nullptr ? std::nullopt : std::optional<std::string_view>(*text);
    };
    if (!view("allow") && !view("disallow")) return Permissions::none();
    std::vector<std::string> unknown;
    return parse_permissions(view("allow"), view("disallow"), unknown);
  }

  void add(std::string_view lane, LaneChange change) {
    const auto mark = lane.rfind('_');
    if (mark == std::string_view::npos) return;
    const auto road = network_.find_road(lane.substr(0, mark));
    const auto index = parse_integer<std::uint32_t>(lane.substr(mark + 1));
    if (!road || !index || *index >= network_.roads[*road].lane_count) return;
    change.lane = network_.roads[*road].lane(*index);
    changes.push_back(change);
  }

  const Network& network_;
};

}  // namespace

std::vector<LaneChange> read_lane_changes(std::span<const std::string> additional_files,
                                          const Network& network) {
  Reader reader(network);
  for (const std::string& file : additional_files) reader.read(file);
  return std::move(reader.changes);
}

}  // namespace thalweg
