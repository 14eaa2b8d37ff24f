// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <exception>

#include "app/commands.hpp"
#include "app/messages.hpp"
#include "core/error.hpp"
#include "core/nearest.hpp"

namespace {

using thalweg::InputError;

struct Command {
  const char* name;
  const char* summary;
  int (*run)(std::span<const std::string>);
};

constexpr std::array<Command, 7> commands{{
    {"run", "one headless run of SUMO with one router in charge", &thalweg::run_command},
    {"compare", "the same demand under several routers and seeds: who arrives earlier?",
     &thalweg::compare_command},
    {"days", "day after day on the same demand: what does a router learn?", &thalweg::days_command},
    {"route", "routes on a network, without SUMO", &thalweg::route_command},
    {"lab", "the paper's experiments", &thalweg::lab_command},
    {"network", "what a network looks like to the router", &thalweg::network_command},
    {"doctor", "which SUMO is used, and what is missing", &thalweg::doctor_command},
}};

void print_usage(std::FILE* stream) {
  fmt::print(stream, "thalweg {}: re-routes SUMO's vehicles through the partitioned graph\n\nUsage:\n",
             THALWEG_VERSION);
  for (const Command& command : commands)
    fmt::print(stream, "  thalweg {:<8} {}\n", command.name, command.summary);
  fmt::print(stream, "\n'thalweg COMMAND --help' lists the options of each.\n");
}

int run(const std::vector<std::string>& arguments) {
  if (arguments.empty()) {
    print_usage(stderr);
    return 1;
  }
  const std::string& first = arguments.front();
  if (first == "--help" || first == "-h" || first == "-?" || first == "help") {
    print_usage(stdout);
    return 0;
  }
  if (first == "--version" || first == "-V") {
    fmt::print("thalweg {}\n", THALWEG_VERSION);
    return 0;
  }
  for (const Command& command : commands) {
    if (first == command.name) return command.run(std::span(arguments).subspan(1));
  }
  if (first.starts_with("--save-template"))
    return thalweg::run_command(arguments);  // sumolib.options.pullOptions
  std::vector<std::string> names;
  names.reserve(commands.size());
  for (const Command& command : commands) names.emplace_back(command.name);
  throw InputError(fmt::format("there is no command '{}'{}; 'thalweg --help' lists them", first,
                               thalweg::did_you_mean(first, names)));
}

}  // namespace

int main(int count, char** values) {
  try {
    return run(std::vector<std::string>(values + 1, values + count));
  } catch (const std::exception& error) {
    thalweg::tell_error(error.what());
    return 1;
  }
}
