// SPDX-License-Identifier: Apache-2.0
#include "traffic/memory_file.hpp"

#include <fmt/format.h>

#include "core/number.hpp"
#include "xml/reader.hpp"
#include "xml/writer.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

fs::path times_file(const fs::path& folder) { return folder / "times.xml.gz"; }
fs::path routes_file(const fs::path& folder) { return folder / "routes.rou.xml.gz"; }

RoadId road_of(std::string_view id, const Network& network, const xml::Element& element) {
  const auto road = network.find_road(id);
  if (!road)
    throw element.error(fmt::format("the edge '{}' is not in the net: a memory of another city?", id));
  return *road;
}

class TimesHandler : public xml::Handler {
 public:
  TimesHandler(const Network& network, Memory& memory) : network_(network), memory_(memory) {}

  void start(const xml::Element& element) override {
    if (element.name() == "memory") {
      memory_.bin = element.time("bin");
      const int days = element.integer("days");
      if (memory_.bin <= 0 || days < 0)
        throw element.error("a bin above 0 and days of at least 0 are expected");
      memory_.days = static_cast<std::size_t>(days);
      memory_.commute = element.number("commute");
      is_memory_ = true;
    } else if (element.name() == "interval" && is_memory_) {
      begin_interval(element);
    } else if (element.name() == "edge" && is_memory_) {
      add_time(element);
    }
  }

  [[nodiscard]] bool is_memory() const { return is_memory_; }

 private:
  void begin_interval(const xml::Element& element) {
    const Millis begin = element.time("begin");
    const bool is_next = begin >= static_cast<Millis>(memory_.times.size()) * memory_.bin;
    if (!is_next || begin % memory_.bin != 0 || element.time("end") != begin + memory_.bin)
      throw element.error("the intervals must be bins of the memory in their order");
    memory_.times.resize(static_cast<std::size_t>(begin / memory_.bin) + 1);
  }

  void add_time(const xml::Element& element) {
    if (memory_.times.empty()) throw element.error("it is in no interval");
    const RememberedTime time{.road = road_of(element.require("id"), network_, element),
                              .seconds = element.number("traveltime"),
                              .observations = element.number("observations"),
                              .days = static_cast<std::size_t>(element.integer("days"))};
    if (time.seconds < 0 || time.observations < 0 || element.integer("days") < 1)
      throw element.error("the travel time or the observations are negative, or there is no day");
    auto& times = memory_.times.back();
    if (!times.empty() && !(times.back().road < time.road))
      throw element.error("the edges must be in the order of the net, each once");
    times.push_back(time);
  }

  const Network& network_;
  Memory& memory_;
  bool is_memory_ = false;
};

class RoutesHandler : public xml::Handler {
 public:
  RoutesHandler(const Network& network, Memory& memory) : network_(network), memory_(memory) {}

  void start(const xml::Element& element) override {
    if (element.name() == "vehicle") {
      const Millis depart = element.time("depart");
      if (!memory_.trips.empty() && depart < memory_.trips.back().depart)
        throw element.error("the vehicles must be in the order of their departures");
      memory_.trips.push_back({.vehicle = std::string(element.require("id")), .depart = depart});
      place_ = element.place();
    } else if (element.name() == "route") {
      if (memory_.trips.empty()) throw element.error("it belongs to no vehicle");
      for (const auto id : split(element.require("edges"), " \t\r\n"))
        memory_.trips.back().route.push_back(road_of(id, network_, element));
    }
  }
  void end(std::string_view name) override {
    if (name == "vehicle" && memory_.trips.back().route.empty())
      throw InputError(
          fmt::format("{}: the vehicle '{}' has no route", place_, memory_.trips.back().vehicle));
  }

 private:
  const Network& network_;
  Memory& memory_;
  std::string place_;  ///< of the vehicle
};

void write_times(const fs::path& file, const Network& network, const Memory& memory,
                 std::string_view header) {
  xml::Writer writer(file, header);
  writer.open("memory")
      .attribute("days", fmt::format("{}", memory.days))
      .attribute("bin", format_seconds(memory.bin))
      .attribute("commute", fmt::format("{:.2f}", memory.commute));
  for (std::size_t at = 0; at < memory.times.size(); ++at) {
    if (memory.times[at].empty()) continue;
    const Millis begin = static_cast<Millis>(at) * memory.bin;
    writer.open("interval")
        .attribute("begin", format_seconds(begin))
        .attribute("end", format_seconds(begin + memory.bin));
    for (const RememberedTime& time : memory.times[at]) {
      writer.open("edge")
          .attribute("id", network.roads[time.road].id)
          .attribute("traveltime", fmt::format("{:.3f}", time.seconds))
          .attribute("observations", fmt::format("{:.2f}", time.observations))
          .attribute("days", fmt::format("{}", time.days))
          .close();
    }
    writer.close();
  }
  writer.commit();
}

void write_routes(const fs::path& file, const Network& network, const Memory& memory,
                  std::string_view header) {
  xml::Writer writer(file, header);
  writer.open("routes");
  for (const RememberedTrip& trip : memory.trips) {
    std::string edges;
    for (const RoadId road : trip.route) {
      if (!edges.empty()) edges += ' ';
      edges += network.roads[road].id;
    }
    writer.open("vehicle").attribute("id", trip.vehicle).attribute("depart", format_seconds(trip.depart));
    writer.open("route").attribute("edges", edges).close().close();
  }
  writer.commit();
}

}  // namespace

void write_memory(const fs::path& folder, const Network& network, const Memory& memory,
                  std::string_view header) {
  fs::create_directories(folder);
  write_routes(routes_file(folder), network, memory, header);
  write_times(times_file(folder), network, memory, header);
}

Memory read_memory(const fs::path& folder, const Network& network) {
  Memory memory;
  TimesHandler times(network, memory);
  xml::read(times_file(folder), times);
  verify(times.is_memory(), fmt::format("'{}' is no memory: write one with 'thalweg days' or --memory-output",
                                        times_file(folder).string()));
  RoutesHandler routes(network, memory);
  xml::read(routes_file(folder), routes);
  return memory;
}

}  // namespace thalweg
