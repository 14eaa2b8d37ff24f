// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <streambuf>
#include <string>
#include <string_view>
#include <vector>

namespace thalweg {

/// Takes what SUMO prints on the error stream of this process while it lives: SUMO warns of the same thing
/// for hundreds of vehicles, and what else there is to read would be lost among them.
///
/// Of the warnings that differ in names and numbers only, the first three are shown; `end` tells how many
/// more there were. Errors are kept for the message that tells of SUMO's end. Everything else is shown as it
/// comes.
class SumoWords : public std::streambuf {
 public:
  /// `show` gets whole lines, each with its end.
  explicit SumoWords(std::function<void(std::string_view)> show);
  ~SumoWords() override;
  SumoWords(const SumoWords&) = delete;
  SumoWords& operator=(const SumoWords&) = delete;

  /// Gives the error stream back, and tells how many more warnings there were; `log`: the file that has them
  /// all.
  void end(std::string_view log);
  /// The errors, in SUMO's words, without "Error: ".
  [[nodiscard]] std::string errors() const;
  /// All that was printed.
  [[nodiscard]] const std::string& all() const { return all_; }

 protected:
  int_type overflow(int_type character) override;
  std::streamsize xsputn(const char* text, std::streamsize count) override;

 private:
  struct Kind {
    std::string first;  ///< line
    std::size_t count = 0;
  };

  void take(std::string_view text);
  void take_line(std::string_view line);
  Kind& kind_of(std::string_view line);

  std::function<void(std::string_view)> show_;
  std::streambuf* stream_;
  std::mutex mutex_;  ///< SUMO has threads, too
  std::string all_;
  std::size_t line_ = 0;  ///< where it begins in all_
  std::string errors_;
  std::vector<Kind> kinds_;                             ///< in their order
  std::map<std::string, std::size_t> kind_of_pattern_;  ///< in kinds_
  bool is_shown_ = true;                                ///< what the lines that go on with the last one share
  bool is_error_ = false;
};

}  // namespace thalweg
