// SPDX-License-Identifier: Apache-2.0
#include "demand/vehicle_types.hpp"

#include <fmt/format.h>

#include "core/hash.hpp"
#include "core/number.hpp"
#include "demand/vehicle_file.hpp"

namespace thalweg {
namespace {

/// nullopt: the attribute is not there.
std::optional<double> positive(const xml::Node& node, std::string_view attribute) {
  const std::string* text = node.find(attribute);
  if (text == nullptr) return std::nullopt;
  const auto value = parse_number(*text);
  if (!value || *value < 0) throw node.error(fmt::format("{} '{}' is no number from 0 on", attribute, *text));
  return value;
}

}  // namespace

VehicleTypes::VehicleTypes() {
  for (const auto& [id, vehicle_class] : default_types()) {
    types_[id] = {.id = id, .vehicle_class = vehicle_class, .max_speed = default_max_speed(vehicle_class)};
  }
}

void VehicleTypes::add(const xml::Node& node) {
  if (node.name == "vType") {
    const auto name = node.value_or("vClass", "passenger");
    const auto vehicle_class = parse_vehicle_class(name);
    if (!vehicle_class) throw node.error(fmt::format("nobody knows the vehicle class '{}'", name));
    types_[node.require("id")] = {
        .id = node.require("id"),
        .vehicle_class = *vehicle_class,
        .max_speed = positive(node, "maxSpeed").value_or(default_max_speed(*vehicle_class)),
        .share = positive(node, "probability").value_or(1)};
    return;
  }
  auto& members = distributions_[node.require("id")];
  for (const xml::Node& child : node.children) {
    if (child.name != "vType") continue;
    add(child);
    members.push_back(types_[child.require("id")]);
  }
  const auto shares = split(node.value_or("probabilities", ""), " ,");
  const auto names = split(node.value_or("vTypes", ""), " ,");
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto known = types_.find(std::string(names[i]));
    if (known == types_.end()) throw node.error(fmt::format("the type '{}' is not known", names[i]));
    members.push_back(known->second);
    if (i < shares.size()) members.back().share = parse_number(shares[i]).value_or(1);
  }
  double sum = 0;
  for (const DrivenType& member : members) sum += member.share;
  if (!(sum > 0)) throw node.error("this distribution has no type");
}

const DrivenType* VehicleTypes::find(std::string_view type, std::string_view vehicle) const {
  if (const auto own = types_.find(std::string(type)); own != types_.end()) return &own->second;
  const auto mixed = distributions_.find(std::string(type));
  if (mixed == distributions_.end()) return nullptr;
  double sum = 0;
  for (const DrivenType& member : mixed->second) sum += member.share;
  double left = unit_hash(vehicle) * sum;
  for (const DrivenType& member : mixed->second) {
    left -= member.share;
    if (left < 0) return &member;
  }
  return &mixed->second.back();
}

}  // namespace thalweg
