// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <thread>

#include "app/commands.hpp"
#include "app/messages.hpp"
#include "app/routing_options.hpp"
#include "app/start.hpp"
#include "core/error.hpp"
#include "lab/experiment.hpp"
#include "xml/writer.hpp"

namespace thalweg {
namespace {

void print_list() {
  fmt::print("The paper's experiments, and the project's own:\n\n");
  for (const auto& experiment : lab::experiments())
    fmt::print("  {:<14} {}\n", experiment.name, experiment.summary);
  fmt::print("\n'thalweg lab NAME' runs one, 'thalweg lab NAME --help' lists its parameters.\n");
}

Options options_of(const lab::Experiment& experiment) {
  std::vector<OptionSpec> specs;
  for (const auto& [name, type, default_value, help, short_name] : experiment.parameters)
    specs.push_back({"experiment", name, short_name, type, default_value, help});
  specs.push_back({"input", "configuration-file", 'c', "FILE", "", "Parameters from a file"});
  specs.push_back({"output", "output", 'o', "FILE", "", "The table as CSV"});
  specs.push_back({"processing", "seed", 0, "INT", "23423", "All that is drawn comes from it"});
  specs.push_back({"processing", "repetitions", 0, "INT", fmt::format("{}", experiment.repetitions),
                   "Repetitions of what is drawn or timed"});
  specs.push_back({"processing", "threads", 0, "INT",
                   fmt::format("{}", std::max(1U, std::thread::hardware_concurrency())),
                   "Changes how long it takes, not the result"});
  return {"lab " + experiment.name, experiment.summary, std::move(specs)};
}

lab::Parameters parameters_of(const lab::Experiment& experiment, const Options& options) {
  std::map<std::string, std::string, std::less<>> values;
  for (const auto& parameter : experiment.parameters) {
    values[parameter.name] = parameter.type == "BOOL" ? (options.flag(parameter.name) ? "true" : "false")
                                                      : options.text(parameter.name);
  }
  return lab::Parameters(std::move(values));
}

std::string header_of(const lab::Experiment& experiment, const Options& options) {
  std::string out = fmt::format("thalweg {} lab {}: seed {}, {} repetitions", THALWEG_VERSION,
                                experiment.name, options.count("seed"), options.count("repetitions"));
  for (const auto& parameter : experiment.parameters) {
    if (!options.text(parameter.name).empty())
      out += fmt::format(", {} {}", parameter.name, options.text(parameter.name));
  }
  return out;
}

int run_experiment(const lab::Experiment& experiment, std::span<const std::string> arguments) {
  Options options = options_of(experiment);
  if (!start(options, arguments, OwnConfiguration::yes)) return 0;
  verify(options.count("repetitions") >= 1, "--repetitions must be at least 1");
  const std::size_t threads = thread_count(options);

  fmt::print("{}\n\n", header_of(experiment, options));
  std::fflush(stdout);
  lab::Report report;
  {
    ProgressLine line;
    std::mutex mutex;
    auto last = std::chrono::steady_clock::now();
    const auto progress = [&](std::string_view text) {
      const std::scoped_lock lock(mutex);
      const auto now = std::chrono::steady_clock::now();
      if (now - last < std::chrono::milliseconds(200)) return;
      last = now;
      line.show(text);
    };
    report = experiment.run({.parameters = parameters_of(experiment, options),
                             .seed = options.count("seed"),
                             .repetitions = options.count("repetitions"),
                             .threads = threads,
                             .progress = progress});
  }
  const std::string text = report.text();
  std::fwrite(text.data(), 1, text.size(), stdout);
  if (!options.text("output").empty()) {
    OutputFile output(options.text("output"));
    output.write(report.csv());
    output.commit();
  }
  return 0;
}

}  // namespace

int lab_command(std::span<const std::string> arguments) {
  if (arguments.empty() || arguments.front() == "--help" || arguments.front() == "-h" ||
      arguments.front() == "-?") {
    print_list();
    return 0;
  }
  return run_experiment(lab::find_experiment(arguments.front()), arguments.subspan(1));
}

}  // namespace thalweg
