// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace thalweg {

/// What a program of SUMO's says of its options (`--save-template`): so every version is understood as it is.
class SumoOptions {
 public:
  /// Asks the program. InputError when it does not answer.
  static SumoOptions ask(const std::filesystem::path& program);

  struct Option {
    std::string type;  ///< BOOL, INT, FLOAT, TIME, STR, FILE
    std::string help;
  };
  /// The option of this name or synonym; its proper name in `first`. Null when there is none.
  [[nodiscard]] const std::pair<const std::string, Option>* find(std::string_view name) const;
  /// The option that an argument of a command line names ("--fcd-output=x", "-e"). Null: none, it is a value.
  [[nodiscard]] const std::pair<const std::string, Option>* find_argument(std::string_view argument) const;
  [[nodiscard]] std::vector<std::string> names() const;

  [[nodiscard]] static bool is_input(std::string_view name, const Option& option);
  [[nodiscard]] static bool is_output(std::string_view name, const Option& option);

 private:
  std::map<std::string, Option, std::less<>> options_;
  std::map<std::string, std::string, std::less<>> synonyms_;
  friend class TemplateHandler;
};

}  // namespace thalweg
