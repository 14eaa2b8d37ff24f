// SPDX-License-Identifier: Apache-2.0
#include "demand/additional.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "demand/input_scan.hpp"
#include "xml/node.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 13> writing_elements{
    "e1Detector",       "inductionLoop", "instantInductionLoop", "e2Detector",
    "laneAreaDetector", "e3Detector",    "entryExitDetector",    "edgeData",
    "laneData",         "vTypeProbe",    "routeProbe",           "overheadWireSegment",
    "calibrator"};

bool is_special(std::string_view value) {
  static constexpr std::array<std::string_view, 7> names{"",    "-",   "stdout",   "stderr",
                                                         "NUL", "nul", "/dev/null"};
  if (std::find(names.begin(), names.end(), value) != names.end()) return true;
  const auto colon = value.rfind(':');  // host:port
  return colon != std::string_view::npos && colon > 1 && colon + 1 < value.size() &&
         value.find_first_not_of("0123456789", colon + 1) == std::string_view::npos;
}

void rewrite(xml::Node& node, const fs::path& source_folder, OutputPlaces& places) {
  const bool writes =
      std::find(writing_elements.begin(), writing_elements.end(), node.name) != writing_elements.end();
  for (auto& [name, value] : node.attributes) {
    const bool is_output = (writes && name == "file") || name == "dest" || name == "output";
    const bool is_input = !is_output && (name == "file" || name == "href" || name == "imgFile");
    if (is_output) value = places.place(value, source_folder);
    if (is_input && !is_special(value))
      value = fs::absolute(source_folder / value).lexically_normal().string();
  }
  if (node.name == "param") {
    const auto key = node.value_or("key", "");
    if (key == "file" || key.ends_with(".file")) {
      node.set("value", places.place(node.value_or("value", ""), source_folder));
    }
  }
  std::erase_if(node.children, [](const xml::Node& child) {
    return child.name == "param" && switches_rerouting(child.value_or("key", ""));
  });
  for (xml::Node& child : node.children) rewrite(child, source_folder, places);
}

void rewrite_file(const fs::path& from, const fs::path& to, OutputPlaces& places, bool for_duarouter,
                  xml::IncludeChain& chain) {
  chain.enter(from);
  xml::Writer writer(to, fmt::format("from {}", from.filename().string()));
  const fs::path source_folder = fs::absolute(from).parent_path();
  int copies = 0;
  xml::read_nodes(
      from,
      [&](const xml::Element& root) {
        writer.open(root.name());
        for (const auto& a : root.attributes()) {
          if (a.name.find(':') == std::string_view::npos && a.name != "noNamespaceSchemaLocation") {
            writer.attribute(a.name, a.value);
          }
        }
      },
      [&](xml::Node& node) {
        if (is_demand_element(node.name) || (for_duarouter && node.name == "calibrator")) return;
        if (node.name == "include") {
          fs::path copy = to;
          copy.replace_filename(fmt::format("{}.{}", ++copies, to.filename().string()));
          rewrite_file(source_folder / node.require("href"), copy, places, for_duarouter, chain);
          node.set("href", copy.string());
        } else {
          rewrite(node, source_folder, places);
        }
        write_node(writer, node);
      });
  writer.commit();
  chain.leave();
}

}  // namespace

bool switches_rerouting(std::string_view key) {
  return key == "has.rerouting.device" || key.starts_with("device.rerouting.");
}

std::string OutputPlaces::place(std::string_view value, const fs::path& from) {
  if (is_special(value)) return std::string(value);
  const fs::path wanted = fs::absolute(from / value).lexically_normal();
  fs::path relative = fs::path(value).lexically_normal();
  const std::string name = relative.filename().string();
  const auto stem =
      std::min(name.size(), name.rfind('.', name.ends_with(".gz") ? name.size() - 4 : name.npos));
  // The prefix may name folders, too.
  relative.replace_filename(prefix_ + name.substr(0, stem) + suffix_ + name.substr(stem));
  relative = relative.lexically_normal();
  const bool leads_out = relative.is_absolute() || (!relative.empty() && *relative.begin() == "..");
  if (leads_out) relative = relative.filename();
  fs::path free = relative;
  for (int i = 2; taken_.contains(free) && taken_[free] != wanted; ++i) {
    free = relative;
    free.replace_filename(fmt::format("{}-{}", i, relative.filename().string()));
  }
  taken_[free] = wanted;
  const fs::path target = folder_ / free;
  fs::create_directories(target.parent_path());
  return target.string();
}

void rewrite_additional(const fs::path& from, const fs::path& to, OutputPlaces& places, bool for_duarouter) {
  xml::IncludeChain chain;
  rewrite_file(from, to, places, for_duarouter, chain);
}

}  // namespace thalweg
