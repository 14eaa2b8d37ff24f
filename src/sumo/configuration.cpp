// SPDX-License-Identifier: Apache-2.0
#include "sumo/configuration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "core/error.hpp"
#include "core/number.hpp"
#include "xml/reader.hpp"
#include "xml/writer.hpp"

namespace thalweg {
namespace {

std::string value_of_variable(const std::string& name) {
  static constexpr std::array<std::string_view, 3> of_sumo{"LOCALTIME", "UTC", "PID"};
  if (std::find(of_sumo.begin(), of_sumo.end(), name) != of_sumo.end()) return "${" + name + "}";
  const char* value = std::getenv(name.c_str());
  return value == nullptr ? "" : value;
}

std::string with_environment(std::string_view text) {
  std::string result;
  while (true) {
    const auto begin = text.find("${");
    const auto end = begin == std::string_view::npos ? begin : text.find('}', begin + 3);
    if (end == std::string_view::npos) return result.append(text);
    result.append(text.substr(0, begin));
    result.append(value_of_variable(std::string(text.substr(begin + 2, end - begin - 2))));
    text.remove_prefix(end + 1);
  }
}

/// A configuration may have any root but those of SUMO's other files.
void check_root(const xml::Element& root) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 3> others{
      {{"net", "a network: name it with -n, and its demand with -r"},
       {"routes", "a route file: name it with -r, and its network with -n"},
       {"additional", "an additional file: name it with -a"}}};
  for (const auto& [name, what] : others) {
    if (root.name() == name) throw root.error(fmt::format("no configuration, but {}", what));
  }
}

class ConfigurationHandler : public xml::Handler {
 public:
  void start(const xml::Element& element) override {
    if (is_first_) check_root(element);
    is_first_ = false;
    const auto value = element.find("value") ? element.find("value") : element.find("v");
    if (value) settings.push_back({.name = std::string(element.name()), .value = with_environment(*value)});
  }
  std::vector<Setting> settings;

 private:
  bool is_first_ = true;
};

}  // namespace

std::vector<Setting> read_configuration(const std::filesystem::path& file) {
  ConfigurationHandler handler;
  xml::read(file, handler);
  return std::move(handler.settings);
}

void write_configuration(const std::filesystem::path& file, std::string_view header,
                         const std::vector<Setting>& settings) {
  xml::Writer writer(file, header);
  writer.open("configuration");
  for (const auto& [name, value] : settings) writer.open(name).attribute("value", value).close();
  writer.commit();
}

std::vector<std::string> file_list(std::string_view list) {
  std::vector<std::string> files;
  for (const auto part : split(list, ",;")) {
    if (const auto name = trimmed(part); !name.empty()) files.emplace_back(name);
  }
  return files;
}

std::string resolve_files(std::string_view list, const std::filesystem::path& folder) {
  std::string resolved;
  for (const auto& file : file_list(list)) {
    verify(
        std::filesystem::path(file).is_absolute() || folder.string().find_first_of(",;") == std::string::npos,
        fmt::format("'{}' lies in the folder '{}': SUMO takes the comma or semicolon for the end of a file's "
                    "name; rename the folder",
                    file, folder.string()));
    if (!resolved.empty()) resolved += ',';
    resolved += std::filesystem::absolute(folder / file).lexically_normal().string();
  }
  return resolved;
}

std::optional<std::string> Settings::find(std::string_view name) const {
  const auto found =
      std::find_if(settings_.begin(), settings_.end(), [&](const Setting& s) { return s.name == name; });
  if (found == settings_.end()) return std::nullopt;
  return found->value;
}

void Settings::set(std::string_view name, std::string value) {
  const auto found =
      std::find_if(settings_.begin(), settings_.end(), [&](const Setting& s) { return s.name == name; });
  if (found != settings_.end()) {
    found->value = std::move(value);
  } else {
    settings_.push_back({.name = std::string(name), .value = std::move(value)});
  }
}

void Settings::erase(std::string_view name) {
  erase_if([&](const std::string& own) { return own == name; });
}

}  // namespace thalweg
