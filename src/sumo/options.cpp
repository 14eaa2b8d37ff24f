// SPDX-License-Identifier: Apache-2.0
#include "sumo/options.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "core/number.hpp"
#include "sumo/program.hpp"
#include "xml/reader.hpp"

namespace thalweg {

class TemplateHandler : public xml::Handler {
 public:
  explicit TemplateHandler(SumoOptions& options) : options_(options) {}
  void start(const xml::Element& element) override {
    const auto type = element.find("type");
    if (!type) return;
    const std::string name(element.name());
    options_.options_[name] = {.type = std::string(*type), .help = std::string(element.value_or("help", ""))};
    for (const auto synonym : split(element.value_or("synonymes", ""), " ")) {
      options_.synonyms_.emplace(std::string(synonym), name);
    }
  }

 private:
  SumoOptions& options_;
};

SumoOptions SumoOptions::ask(const std::filesystem::path& program) {
  const auto scratch = std::filesystem::temp_directory_path();
  const auto own = fmt::format("thalweg-{}-{}", getpid(), program.filename().string());
  const auto file = scratch / (own + ".options.xml");
  const auto log = scratch / (own + ".options.log");
  const int exit = run_program(program, {"--save-template", file.string()}, log);
  if (exit != 0) {
    throw InputError(
        fmt::format("'{}' does not run (exit {}): {}", program.string(), exit, trimmed(read_text(log))));
  }
  SumoOptions options;
  TemplateHandler handler(options);
  xml::read(file, handler);
  std::filesystem::remove(file);
  std::filesystem::remove(log);
  return options;
}

const std::pair<const std::string, SumoOptions::Option>* SumoOptions::find(std::string_view name) const {
  auto found = options_.find(name);
  if (found == options_.end()) {
    const auto synonym = synonyms_.find(name);
    if (synonym == synonyms_.end()) return nullptr;
    found = options_.find(synonym->second);
  }
  return found == options_.end() ? nullptr : &*found;
}

const std::pair<const std::string, SumoOptions::Option>* SumoOptions::find_argument(
    std::string_view argument) const {
  if (!argument.starts_with('-')) return nullptr;
  argument.remove_prefix(argument.starts_with("--") ? 2 : 1);
  return find(argument.substr(0, argument.find('=')));
}

std::vector<std::string> SumoOptions::names() const {
  std::vector<std::string> names;
  for (const auto& [name, option] : options_) names.push_back(name);
  return names;
}

bool SumoOptions::is_input(std::string_view name, const Option& option) {
  static constexpr std::array<std::string_view, 13> inputs{
      "configuration-file",   "net-file",          "route-files",
      "additional-files",     "weight-files",      "load-state",
      "phemlight-path",       "gui-settings-file", "edgedata-files",
      "alternative-net-file", "selection-file",    "device.fcd-replay.files",
      "breakpoints"};
  if (std::find(inputs.begin(), inputs.end(), name) != inputs.end()) return option.type == "FILE";
  return option.type == "FILE" && (name.ends_with("input-file") || name.starts_with("astar."));
}

bool SumoOptions::is_output(std::string_view name, const Option& option) {
  if (is_input(name, option)) return false;
  return option.type == "FILE" || name.ends_with(".file") || name.ends_with("-output");
}

}  // namespace thalweg
