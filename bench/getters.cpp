// SPDX-License-Identifier: Apache-2.0
// usage: thalweg_getters OPTIONS_OF_SUMO
//
// The floor of what it costs to look at the traffic through libsumo: a run without any router in which at
// each step every vehicle is asked what `thalweg run --period step` must know of it, and nothing is done with
// the answers.
#include <fmt/format.h>
#include <libsumo/libsumo.h>

#include <ctime>
#include <vector>

namespace {

double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

/// Where it is on its route, what it has committed to, and its stops.
void look(const std::string& vehicle) {
  using libsumo::Vehicle;
  static_cast<void>(Vehicle::getRouteID(vehicle));
  static_cast<void>(Vehicle::getRouteIndex(vehicle));
  static_cast<void>(Vehicle::getRoadID(vehicle));
  static_cast<void>(Vehicle::getStopState(vehicle));
  static_cast<void>(Vehicle::getLanePosition(vehicle));
  static_cast<void>(Vehicle::getSpeed(vehicle));
  static_cast<void>(Vehicle::getStops(vehicle));
}

}  // namespace

int main(int argument_count, char** arguments) {
  std::vector<std::string> command(arguments, arguments + argument_count);
  try {
    libsumo::Simulation::start(command);
    const double end = libsumo::Simulation::getEndTime();
    const double begin = cpu_seconds();
    double looking = 0;
    std::size_t looks = 0;
    while (libsumo::Simulation::getMinExpectedNumber() > 0 &&
           (end < 0 || libsumo::Simulation::getTime() < end)) {
      libsumo::Simulation::step();
      const double before = cpu_seconds();
      const auto vehicles = libsumo::Vehicle::getIDList();
      for (const auto& vehicle : vehicles) look(vehicle);
      looks += vehicles.size();
      looking += cpu_seconds() - before;
    }
    const double all = cpu_seconds() - begin;
    fmt::print("{} looks at a vehicle, {:.2f} us each: {:.1f} of {:.1f} s, {:.1f} %\n", looks,
               looking / static_cast<double>(looks) * 1e6, looking, all, 100 * looking / all);
    libsumo::Simulation::close();
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
