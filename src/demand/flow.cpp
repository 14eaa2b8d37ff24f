// SPDX-License-Identifier: Apache-2.0
#include "demand/flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "core/number.hpp"
#include "core/time.hpp"

namespace thalweg {
namespace {

constexpr std::array<std::string_view, 7> flow_attributes{"begin",       "end",     "number", "period",
                                                          "vehsPerHour", "perHour", "id"};

std::optional<Millis> time_of(const xml::Node& flow, std::string_view attribute) {
  const std::string* text = flow.find(attribute);
  if (text == nullptr) return std::nullopt;
  const auto time = parse_time(*text);
  if (!time || *time < 0) throw flow.error(fmt::format("'{}' is no {}", *text, attribute));
  return time;
}

/// The time between two vehicles in ms; a fraction matters: 1,000 vehicles an hour are 3.6 s apart, 1,100 are
/// not a whole number of ms.
std::optional<double> period_of(const xml::Node& flow) {
  if (const auto period = time_of(flow, "period")) return static_cast<double>(*period);
  for (const auto* const name : {"vehsPerHour", "perHour"}) {
    const std::string* text = flow.find(name);
    if (text == nullptr) continue;
    const auto rate = parse_number(*text);
    if (!rate || *rate <= 0) throw flow.error(fmt::format("'{}' is no rate above 0", *text));
    return 3'600'000.0 / *rate;
  }
  return std::nullopt;
}

}  // namespace

std::vector<xml::Node> expand_flow(const xml::Node& flow) {
  if (flow.find("probability") != nullptr || flow.find("poisson") != nullptr ||
      flow.value_or("period", "").starts_with("exp")) {
    throw flow.error("the times of this flow are drawn at random: let duarouter expand it");
  }
  const std::string& id = flow.require("id");
  const Millis begin = time_of(flow, "begin").value_or(0);
  const auto end = time_of(flow, "end");
  auto period = period_of(flow);
  std::optional<std::size_t> number;
  if (const std::string* text = flow.find("number")) {
    number = parse_integer<std::size_t>(*text);
    if (!number || *number > 100'000'000)
      throw flow.error(fmt::format("'{}' is no number of vehicles", *text));
  }
  if (!period) {
    if (!number || !end) throw flow.error("this flow has no end: it needs a number, or a period and an end");
    period = *number == 0 ? 0 : static_cast<double>(*end - begin) / static_cast<double>(*number);
  }
  if (!number && (!end || *period <= 0)) throw flow.error("this flow has no end");
  xml::Node pattern{.name = "trip", .attributes = {}, .children = flow.children, .place = flow.place};
  for (const auto& [name, value] : flow.attributes) {
    const bool own = std::find(flow_attributes.begin(), flow_attributes.end(), name) != flow_attributes.end();
    if (!own) pattern.attributes.emplace_back(name, value);
  }
  const bool has_route = std::any_of(flow.children.begin(), flow.children.end(),
                                     [](const xml::Node& child) { return child.name == "route"; });
  if (has_route || flow.find("route") != nullptr) pattern.name = "vehicle";

  std::vector<xml::Node> expanded;
  for (std::size_t i = 0; !number || i < *number; ++i) {
    const auto depart = begin + static_cast<Millis>(static_cast<double>(i) * *period);
    if (end && depart >= *end) break;
    xml::Node one = pattern;
    one.set("id", fmt::format("{}.{}", id, i));
    one.set("depart", format_seconds(depart));
    expanded.push_back(std::move(one));
  }
  return expanded;
}

}  // namespace thalweg
