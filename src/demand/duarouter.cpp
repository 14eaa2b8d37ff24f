// SPDX-License-Identifier: Apache-2.0
#include "demand/duarouter.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "sumo/options.hpp"
#include "sumo/program.hpp"

namespace thalweg {

namespace fs = std::filesystem;

Duarouter::Duarouter(const Settings& settings, const SumoInstallation& sumo, const fs::path& folder,
                     const std::atomic<bool>& stop)
    : program_(sumo.duarouter), folder_(folder), stop_(stop) {
  require_tool(program_, "duarouter");
  const SumoOptions options = SumoOptions::ask(program_);
  common_ = {"--net-file",
             settings.find("net-file").value_or(""),
             "--ignore-errors",
             "--no-step-log",
             "--skip-new-routes",  // given routes are kept; without it duarouter routes them afresh
             "--unsorted-input",
             "--alternatives-output",
             "NUL",
             "--ptline-routing"};
  if (options.find("ptline-routing") == nullptr) common_.pop_back();
  // CCH is a hundred times faster than the default and finds the same costs, but is new.
  const auto* algorithm = options.find("routing-algorithm");
  const bool has_cch = algorithm != nullptr && algorithm->second.help.find("CCH") != std::string::npos;
  add("--routing-algorithm", has_cch ? "CCH" : "astar");
  for (const char* shared :
       {"additional-files", "begin", "junction-taz", "scale", "mapmatch.distance", "mapmatch.junctions",
        "mapmatch.taz", "weights.minor-penalty", "weights.turnaround-penalty", "weights.tls-penalty"}) {
    const auto value = settings.find(shared);
    if (value && !value->empty() && options.find(shared) != nullptr) add(std::string("--") + shared, *value);
  }
}

std::string Duarouter::route(const std::string& inputs, const fs::path& output,
                             std::vector<std::string> more) const {
  more.insert(more.begin(), {"--route-files", inputs, "--output-file", output.string()});
  more.insert(more.end(), common_.begin(), common_.end());
  const fs::path log = folder_ / "duarouter.log";
  const int exit = run_program(program_, more, log, stop_);
  std::string words = read_text(log);
  if (exit != 0) {
    throw InputError(fmt::format("duarouter could not route the demand (exit {}; {}):\n{}", exit,
                                 log.string(), words.substr(words.size() > 2000 ? words.size() - 2000 : 0)));
  }
  return words;
}

void Duarouter::add(std::string name, std::string value) {
  common_.push_back(std::move(name));
  common_.push_back(std::move(value));
}

}  // namespace thalweg
