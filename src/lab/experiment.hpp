// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "report/statistics.hpp"

namespace thalweg::lab {

/// A parameter of an experiment, declared as the subcommands declare their options.
struct Parameter {
  std::string name;
  std::string type;  ///< INT, FLOAT, BOOL, STR, FILE; LIST: whole numbers "2,5,10..50/10"
  std::string default_value;
  std::string help;
  char short_name = 0;
};

/// The values of an experiment's parameters, by name. The getters throw InputError, naming the parameter.
class Parameters {
 public:
  explicit Parameters(std::map<std::string, std::string, std::less<>> values) : values_(std::move(values)) {}
  [[nodiscard]] const std::string& text(std::string_view name) const { return values_.find(name)->second; }
  [[nodiscard]] bool flag(std::string_view name) const { return text(name) == "true"; }
  [[nodiscard]] double number(std::string_view name) const;
  /// A whole number of at least `least`.
  [[nodiscard]] std::uint64_t count(std::string_view name, std::uint64_t least = 0) const;
  /// "20..200/20,500": numbers, and ranges with a step (1 by default). Not empty, each at least `least`.
  [[nodiscard]] std::vector<std::uint64_t> list(std::string_view name, std::uint64_t least = 0) const;

 private:
  std::map<std::string, std::string, std::less<>> values_;
};

/// What an experiment is given. Everything that it draws comes from `seed`, so that its report is the same
/// for any number of threads; clocks are read only where a time is what it measures.
struct Run {
  Parameters parameters;
  std::uint64_t seed = 23423;
  std::size_t repetitions = 1;
  std::size_t threads = 1;
  std::function<void(std::string_view)> progress;  ///< may be called by any thread

  /// Calls work(repetition, worker) for all repetitions, in parallel; worker < threads. `what` goes before
  /// the progress.
  void repeat(std::string_view what, const std::function<void(std::size_t, std::size_t)>& work) const;
  void say(std::string_view text) const {
    if (progress) progress(text);
  }
};

/// What it found: a table (its header names the units), and sentences beside it.
struct Report {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows{};
  std::vector<std::string> notes{};

  [[nodiscard]] std::string csv() const;
  [[nodiscard]] std::string text() const;
};

struct Experiment {
  std::string name;
  std::string summary;  ///< one line
  std::vector<Parameter> parameters{};
  std::size_t repetitions = 1;  ///< by default
  Report (*run)(const Run&) = nullptr;
};

/// The one list of them all, in the order of the paper.
[[nodiscard]] std::span<const Experiment> experiments();
/// InputError (with the nearest name) when there is none.
[[nodiscard]] const Experiment& find_experiment(std::string_view name);

/// Cells of a report. Empty: not measured.
[[nodiscard]] std::string cell(double value, int digits = 3);
[[nodiscard]] std::string cell(std::uint64_t value);
/// Two cells: the mean and half the width of its 95 % interval.
void add_estimate(std::vector<std::string>& row, const Estimate& estimate, int digits = 3);

/// InputError when a grid of this side is none (0, 1), has too many vertices for their ids, or would need
/// more than this machine's memory at `bytes_per_vertex`; the estimate is in the message.
void verify_grid(std::uint64_t side, double bytes_per_vertex);
/// InputError when `bytes` are more than this machine has.
void verify_memory(std::string_view what, double bytes);

/// CPU time of the calling thread since the call before it (or since it was made): what else runs on the
/// machine is not counted, only what it does to the caches.
class StopWatch {
 public:
  StopWatch();
  double lap_ms();

 private:
  std::int64_t start_;
};

/// The median; NaN of nothing.
[[nodiscard]] double median(std::vector<double> values);

}  // namespace thalweg::lab
