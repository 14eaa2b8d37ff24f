// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/time.hpp"
#include "sumo/configuration.hpp"

namespace thalweg {

/// One option, declared as SUMO's programs declare theirs.
struct OptionSpec {
  std::string section;  ///< "input", "output", "routing" ..
  std::string name;     ///< lower case, dotted
  char short_name = 0;
  std::string type;  ///< BOOL, INT, FLOAT, TIME, STR, FILE
  std::string default_value;
  std::string help;
};

/// The options of a subcommand, with SUMO's manners: --x v and --x=v, booleans with or without a value, times
/// in seconds or [d:]h:m:s, -c with any sections, --save-configuration, --save-template.
class Options {
 public:
  Options(std::string command, std::string summary, std::vector<OptionSpec> specs);

  /// Reads the command line. What follows "--" is kept for SUMO. InputError: unknown (with the nearest name),
  /// a value missing or not of its type.
  void parse(std::span<const std::string> arguments);
  /// Takes a setting of a configuration file unless the command line has it. False: it is not one of ours.
  bool take(const Setting& setting);
  /// Takes all of a configuration of ours; its files are seen from its own folder. InputError: it has other
  /// options.
  void take_file(const std::filesystem::path& file);

  [[nodiscard]] bool is_set(std::string_view name) const;  ///< differs from its default
  [[nodiscard]] bool on_command_line(std::string_view name) const;
  [[nodiscard]] const std::string& text(std::string_view name) const;
  [[nodiscard]] bool flag(std::string_view name) const;
  [[nodiscard]] double number(std::string_view name) const;
  [[nodiscard]] std::uint64_t count(std::string_view name) const;  ///< a whole number >= 0
  [[nodiscard]] Millis time(std::string_view name) const;
  [[nodiscard]] const std::vector<std::string>& for_sumo() const { return for_sumo_; }
  [[nodiscard]] const std::vector<OptionSpec>& specs() const { return specs_; }

  [[nodiscard]] std::string help() const;
  /// The template that sumolib.options.pullOptions reads; with `values`: the configuration as it is.
  [[nodiscard]] std::string to_xml(bool values) const;
  /// The comment on top of an output: when, by what, and with which options it was made.
  [[nodiscard]] std::string header() const;
  /// Does what --help, --version, --save-template and --save-configuration ask for; true when the command is
  /// done with that.
  [[nodiscard]] bool answered() const;

 private:
  struct Value {
    std::string text;
    bool from_command_line = false;
  };
  [[nodiscard]] const OptionSpec* find(std::string_view name) const;
  /// In the order of their first options.
  [[nodiscard]] std::vector<std::string> sections() const;
  void set(const OptionSpec& spec, std::string value, bool from_command_line);

  std::string command_;
  std::string summary_;
  std::vector<OptionSpec> specs_;
  std::map<std::string, Value, std::less<>> values_;
  std::vector<std::string> for_sumo_;
};

}  // namespace thalweg
