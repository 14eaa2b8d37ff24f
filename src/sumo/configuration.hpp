// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace thalweg {

struct Setting {
  std::string name;
  std::string value;
};

/// A configuration in SUMO's format: any root, sections of any name, `<option value="..."/>`. In the file's
/// order. "${NAME}" is that variable of the environment, empty where there is none; "${LOCALTIME}", "${UTC}"
/// and "${PID}" are left to SUMO. InputError: no XML, or a network, a route file or an additional file.
std::vector<Setting> read_configuration(const std::filesystem::path& file);

void write_configuration(const std::filesystem::path& file, std::string_view header,
                         const std::vector<Setting>& settings);

/// A list of files ("a.xml,b.xml") made absolute, seen from `folder`. InputError: the folder has a comma in
/// its name, so that SUMO could not read the list.
std::string resolve_files(std::string_view list, const std::filesystem::path& folder);
std::vector<std::string> file_list(std::string_view list);

/// Settings by name; later ones win.
class Settings {
 public:
  [[nodiscard]] std::optional<std::string> find(std::string_view name) const;
  void set(std::string_view name, std::string value);
  void erase(std::string_view name);
  template <class Predicate>
  void erase_if(Predicate predicate) {
    std::erase_if(settings_, [&](const Setting& setting) { return predicate(setting.name); });
  }
  [[nodiscard]] const std::vector<Setting>& all() const { return settings_; }

 private:
  std::vector<Setting> settings_;
};

}  // namespace thalweg
