// SPDX-License-Identifier: Apache-2.0
#include "app/routing_options.hpp"

#include <fmt/format.h>

#include "app/order_cache_option.hpp"
#include "core/error.hpp"

namespace thalweg {
namespace {

std::string seconds(Millis t) { return fmt::format("{}", to_seconds(t)); }

}  // namespace

std::vector<OptionSpec> routing_options() {
  const ControlOptions control;
  const StrategyOptions strategy;
  const ChoiceRule& rule = strategy.rule;
  std::vector<OptionSpec> specs{
      {"routing", "period", 0, "STR", seconds(control.period),
       "Every vehicle is asked once a period; those that look ahead also before signals that they know. "
       "'step': at each step"},
      {"routing", "window", 0, "TIME", seconds(control.window), "Travel times are averaged over this time"},
      {"routing", "adaptation-interval", 0, "TIME", seconds(control.adaptation_interval),
       "The measured travel times that vehicles decide by are updated so often"},
      {"routing", "share", 0, "FLOAT", fmt::format("{}", control.share),
       "Share of the vehicles that is ours, by a hash of their ids"},
      {"routing", "compliance", 0, "FLOAT", fmt::format("{}", control.compliance),
       "Probability that a driver follows a piece of advice"},
      {"routing", "gain.relative", 0, "FLOAT", fmt::format("{}", rule.relative),
       "A vehicle changes when it gains more than this share of the time left"},
      {"routing", "gain.spread", 0, "FLOAT", fmt::format("{}", rule.spread),
       "and up to this share on top, different for each vehicle"},
      {"routing", "gain.absolute", 0, "TIME", seconds(rule.absolute), "plus this time"},
      {"routing", "toll", 0, "FLOAT", fmt::format("{}", strategy.toll),
       "forecast, memory: share of the delay it causes the others that a vehicle counts as its own"},
      {"routing", "no-signal-phases", 0, "BOOL", "false",
       "forecast, booking, marginal, memory: count on mean waits at signals, not on what they will show"},
      {"routing", "no-assumed-departures", 0, "BOOL", "false",
       "forecast, booking, marginal, memory: do not assume that the last ten minutes' departures come again"},
      {"routing", "stall", 0, "TIME", seconds(control.stall),
       "A run without an end stops when nothing has arrived for so long"},
      threads_option(),
      no_cache_option(),
  };
  for (auto& spec : penalty_options()) specs.push_back(std::move(spec));
  return specs;
}

std::vector<OptionSpec> penalty_options() {
  const TurnPenalties penalties;
  return {
      {"routing", "weights.minor-penalty", 0, "TIME", seconds(penalties.minor),
       "Penalty for a turn that gives way"},
      {"routing", "weights.turnaround-penalty", 0, "TIME", seconds(penalties.turnaround),
       "Penalty for a turn-around"},
      {"routing", "weights.tls-penalty", 0, "TIME", seconds(penalties.signal),
       "Penalty for a signalled turn"},
  };
}

OptionSpec threads_option() {
  return {"processing", "threads", 0,
          "INT",        "1",       "Threads of the router; the result does not depend on them"};
}

ControlOptions control_options(const Options& options) {
  ControlOptions control;
  control.period = 0;
  if (options.text("period") != "step") {
    const auto period = parse_time(options.text("period"));
    verify(period.has_value() && *period > 0,
           fmt::format("--period {}: this is neither a time above 0 nor 'step'", options.text("period")));
    control.period = *period;
  }
  control.window = options.time("window");
  verify(control.window > 0, "--window must be above 0");
  control.adaptation_interval = options.time("adaptation-interval");
  verify(control.adaptation_interval >= 0, "--adaptation-interval must not be below 0");
  control.share = options.number("share");
  verify(control.share >= 0 && control.share <= 1, "--share must be from 0 to 1");
  control.compliance = options.number("compliance");
  verify(control.compliance >= 0 && control.compliance <= 1, "--compliance must be from 0 to 1");
  control.stall = options.time("stall");
  control.penalties = turn_penalties(options);
  return control;
}

StrategyOptions strategy_options(const Options& options) {
  const double toll = options.number("toll");
  verify(toll >= 0 && toll <= 10, "--toll must be from 0 to 10");
  return {.rule = {.relative = options.number("gain.relative"),
                   .spread = options.number("gain.spread"),
                   .absolute = options.time("gain.absolute")},
          .toll = toll,
          .signal_phases = !options.flag("no-signal-phases"),
          .assumed_departures = !options.flag("no-assumed-departures"),
          .threads = thread_count(options),
          .order_cache = order_cache(options)};
}

TurnPenalties turn_penalties(const Options& options) {
  return {.minor = options.time("weights.minor-penalty"),
          .turnaround = options.time("weights.turnaround-penalty"),
          .signal = options.time("weights.tls-penalty")};
}

std::size_t thread_count(const Options& options) {
  const auto threads = options.count("threads");
  verify(threads >= 1 && threads <= 256, "--threads must be from 1 to 256");
  return threads;
}

}  // namespace thalweg
