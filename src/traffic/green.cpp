// SPDX-License-Identifier: Apache-2.0
#include "traffic/green.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace thalweg {
namespace {

enum class Light : std::uint8_t { closed, yellow, permissive_after_stop, permissive, open };

Light light(const SignalPhase& phase, std::size_t link) {
  if (link >= phase.state.size()) return Light::closed;
  switch (phase.state[link]) {
    case 'G':
    case 'O':  // switched off, the right of way
      return Light::open;
    case 'g':
    case 'o':
      return Light::permissive;
    case 's':
      return Light::permissive_after_stop;
    case 'y':
    case 'Y':
      return Light::yellow;
    default:
      return Light::closed;
  }
}

/// What passes in a second of it, against one of protected green.
double flow(Light light, double permissive) {
  if (light == Light::open) return 1;
  if (light == Light::permissive) return permissive;
  return light == Light::permissive_after_stop ? permissive / 2 : 0;
}

struct Seconds {
  std::vector<const SignalPhase*> phases;  ///< of each second of the cycle
  bool is_exact = true;                    ///< no phase was rounded
};
Seconds by_second(const SignalProgramme& programme) {
  constexpr std::size_t longest_cycle = 3600;  // s; a strange file must not hold us up
  Seconds seconds;
  for (const SignalPhase& phase : programme.phases) {
    const auto room = static_cast<double>(longest_cycle - seconds.phases.size());
    const auto count = std::lround(std::clamp(to_seconds(phase.duration), 0.0, room));
    seconds.phases.insert(seconds.phases.end(), static_cast<std::size_t>(count), &phase);
    seconds.is_exact = seconds.is_exact && from_seconds(static_cast<double>(count)) == phase.duration;
  }
  return seconds;
}

std::vector<std::size_t> until_open(std::span<const SignalPhase* const> phases,
                                    std::span<const std::size_t> links) {
  const std::size_t cycle = phases.size();
  const auto is_open = [&](std::size_t second) {
    return std::any_of(links.begin(), links.end(),
                       [&](std::size_t link) { return flow(light(*phases[second], link), 1) > 0; });
  };
  // From the last to the first, twice round.
  std::vector<std::size_t> until(cycle, cycle);
  for (std::size_t i = 2 * cycle; i-- > 0;)
    until[i % cycle] = is_open(i % cycle) ? 0 : std::min(cycle, until[(i + 1) % cycle] + 1);
  return until;
}

}  // namespace

Green green_of(const SignalProgramme& programme, std::size_t link) {
  Green green;
  for (const SignalPhase& phase : programme.phases) {
    const double seconds = to_seconds(phase.duration);
    green.cycle += seconds;
    switch (light(phase, link)) {
      case Light::open:
        green.priority += seconds;
        break;
      case Light::permissive:
        green.permissive += seconds;
        break;
      case Light::permissive_after_stop:
        green.permissive += seconds / 2;
        break;
      case Light::yellow:
        green.yellow += seconds;
        break;
      case Light::closed:
        break;
    }
  }
  return green;
}

std::vector<std::size_t> seconds_until_open(const SignalProgramme& programme,
                                            std::span<const std::size_t> links) {
  const Seconds seconds = by_second(programme);
  if (!seconds.is_exact) return {};
  return until_open(seconds.phases, links);
}

std::optional<double> coordinated_wait(const SignalProgramme& programme, std::span<const Feeder> feeders,
                                       std::span<const std::size_t> links, double permissive) {
  const std::vector<const SignalPhase*> phases = by_second(programme).phases;
  const std::vector<std::size_t> until = until_open(phases, links);
  const std::size_t cycle = phases.size();
  double weight = 0;
  double sum = 0;
  for (const Feeder& feeder : feeders) {
    const auto travel = static_cast<std::size_t>(std::lround(std::max(0.0, feeder.travel)));
    for (std::size_t second = 0; second < cycle; ++second) {
      const double coming = flow(light(*phases[second], feeder.link), permissive);
      const std::size_t wait = until[(second + travel) % cycle];
      if (coming <= 0) continue;
      if (wait >= cycle) return {};
      weight += coming;
      sum += coming * static_cast<double>(wait);
    }
  }
  if (weight <= 0) return {};
  return sum / weight;
}

}  // namespace thalweg
