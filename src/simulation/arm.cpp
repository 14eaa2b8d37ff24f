// SPDX-License-Identifier: Apache-2.0
#include "simulation/arm.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/nearest.hpp"
#include "core/number.hpp"
#include "core/time.hpp"
#include "routing/strategy.hpp"

namespace thalweg {
namespace {

/// SUMO runs on when a value of its configuration is no number, and measures something else than was asked.
void check_value(const std::string& name, std::string_view type, std::string_view value) {
  const bool is_number = type == "FLOAT" || type == "INT";
  const bool is_time = type == "TIME";
  const bool good = is_number ? parse_number(value).has_value() : !is_time || parse_time(value).has_value();
  if (!good) throw InputError(fmt::format("{}={}: this is no {}", name, value, is_time ? "time" : "number"));
}

Setting device_setting(std::string_view text, const SumoOptions& options) {
  const auto equals = text.find('=');
  verify(equals != std::string_view::npos, fmt::format("'{}' is no setting: write name=value", text));
  const std::string_view key = trimmed(text.substr(0, equals));
  for (const std::string& name : {fmt::format("device.rerouting.{}", key), std::string(key)}) {
    if (const auto* option = options.find(name)) {
      const std::string_view value = trimmed(text.substr(equals + 1));
      check_value(option->first, option->second.type, value);
      return {.name = option->first, .value = std::string(value)};
    }
  }
  std::vector<std::string> names;
  for (const auto& name : options.names()) {
    constexpr std::string_view prefix = "device.rerouting.";
    if (name.starts_with(prefix)) names.push_back(name.substr(prefix.size()));
  }
  throw InputError(
      fmt::format("SUMO's device.rerouting has no setting '{}'{}", key, did_you_mean(key, names)));
}

std::vector<Setting> device(std::string_view more, std::string_view period, const SumoOptions& options) {
  std::vector<Setting> settings{{.name = "device.rerouting.probability", .value = "1"},
                                {.name = "device.rerouting.period", .value = std::string(period)}};
  for (const auto part : split(more, ",")) {
    const Setting setting = device_setting(part, options);
    std::erase_if(settings, [&](const Setting& own) { return own.name == setting.name; });
    settings.push_back(setting);
  }
  return settings;
}

}  // namespace

ArmSpec parse_arm(std::string_view text, const SumoOptions& options) {
  const std::string name(trimmed(text));
  if (name == "given") return {.name = name, .settings = {}};
  if (name == "static") return {.name = name, .free_flow_routes = true, .settings = {}};
  if (name == "one-shot") return {.name = name, .settings = device("", "0", options)};
  if (name == "device") return {.name = name, .settings = device("", "60", options)};
  if (name.starts_with("device:")) {
    return {.name = name, .settings = device(std::string_view(name).substr(7), "60", options)};
  }
  std::vector<std::string> names{"given", "static", "one-shot", "device"};
  for (const auto& entry : strategies()) {
    if (entry.name == name) return {.name = name, .ours = true, .settings = {}};
    names.emplace_back(entry.name);
  }
  throw InputError(fmt::format("there is no strategy or baseline '{}'{}; there are: {}", name,
                               did_you_mean(name, names), fmt::join(names, ", ")));
}

std::vector<std::string> split_arms(std::string_view list) {
  std::vector<std::string> arms;
  for (const auto part : split(list, ",")) {
    const bool continues = !arms.empty() && arms.back().starts_with("device:") &&
                           part.find('=') != std::string_view::npos && !part.starts_with("device:");
    if (continues) {
      arms.back() += fmt::format(",{}", trimmed(part));
    } else {
      arms.emplace_back(trimmed(part));
    }
  }
  return arms;
}

std::string arm_folder(std::string_view name) {
  std::string folder(name);
  std::replace_if(
      folder.begin(), folder.end(), [](char c) { return c == ':' || c == '/' || c == ',' || c == ' '; }, '_');
  return folder;
}

}  // namespace thalweg
