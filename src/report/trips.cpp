// SPDX-License-Identifier: Apache-2.0
#include "report/trips.hpp"

#include <algorithm>
#include <unordered_map>
#include <vector>

#include "core/number.hpp"
#include "xml/reader.hpp"

namespace thalweg {
namespace {

enum class State : std::uint8_t { unseen, finished, running, waiting, removed };

struct Trip {
  State state = State::unseen;
  Millis depart_delay = 0;
  Millis duration = 0;
  Millis time_loss = 0;
  double route_length = 0;
};

std::string_view road_of_lane(std::string_view lane) { return lane.substr(0, lane.rfind('_')); }

class TripReader final : public xml::Handler {
 public:
  TripReader(std::span<const DemandedTrip> demand, RunSummary& run) : demand_(demand), run_(run) {
    index_.reserve(demand.size());
    for (std::size_t i = 0; i < demand.size(); ++i) index_.emplace(demand[i].id, i);
    trips_.resize(demand.size());
  }

  void start(const xml::Element& element) override {
    if (!root_seen_) {
      if (element.name() != "tripinfos") throw element.error("this is no tripinfo output of SUMO");
      root_seen_ = true;
      return;
    }
    if (element.name() != "tripinfo") return;  // persons, containers, what devices add
    const auto found = index_.find(element.require("id"));
    if (found == index_.end() || trips_[found->second].state != State::unseen) {
      ++run_.unknown;
      return;
    }
    Trip& trip = trips_[found->second];
    trip.state = state_of(element, demand_[found->second]);
    if (const auto count = element.find("rerouteNo")) {
      run_.reroutes += parse_integer<std::uint64_t>(*count).value_or(0);
    }
    if (trip.state != State::finished) return;
    trip.depart_delay = element.time("departDelay");
    trip.duration = element.time("duration");
    trip.time_loss = element.time("timeLoss");
    trip.route_length = element.number("routeLength");
  }

  [[nodiscard]] const std::vector<Trip>& trips() const { return trips_; }

 private:
  static State state_of(const xml::Element& element, const DemandedTrip& demanded) {
    if (element.time("depart") < 0) return State::waiting;
    if (element.time("arrival") < 0) return State::running;  // "vaporized" is "end" or empty
    const auto reason = element.value_or("vaporized", "");
    if (reason.empty()) return State::finished;
    if (reason != "teleport") return State::removed;
    const bool arrived = demanded.destination.empty() ||
                         road_of_lane(element.value_or("arrivalLane", "")) == demanded.destination;
    return arrived ? State::finished : State::removed;
  }

  std::span<const DemandedTrip> demand_;
  RunSummary& run_;
  std::unordered_map<std::string_view, std::size_t> index_;
  std::vector<Trip> trips_;
  bool root_seen_ = false;
};

/// Sums are kept in milliseconds, so that their order does not matter.
struct Sums {
  Group group{};
  Millis commute = 0;
  Millis duration = 0;
  Millis depart_delay = 0;
  Millis time_loss = 0;
  double route_length = 0;

  void add(const DemandedTrip& demanded, const Trip& trip, Millis end) {
    ++group.vehicles;
    // SUMO writes a vehicle due exactly at the end as waiting, later ones not at all.
    const bool due = demanded.depart < end;
    const bool was_gone = demanded.is_past && trip.state == State::unseen;
    if (was_gone || (!due && (trip.state == State::unseen || trip.state == State::waiting))) {
      ++group.not_loaded;
      return;
    }
    switch (trip.state) {
      case State::finished:
        ++group.finished;
        commute += trip.depart_delay + trip.duration;
        duration += trip.duration;
        depart_delay += trip.depart_delay;
        time_loss += trip.time_loss;
        route_length += trip.route_length;
        return;
      case State::running:
        ++group.running;
        break;
      case State::waiting:
        ++group.waiting;
        break;
      case State::removed:
      case State::unseen:
        ++group.discarded;
        break;
    }
    commute += std::max<Millis>(0, end - demanded.depart);
  }

  [[nodiscard]] Group means() const {
    const auto mean = [](double sum, std::uint64_t count) {
      return count == 0 ? no_value : sum / static_cast<double>(count);
    };
    Group result = group;
    result.commute_mean = mean(to_seconds(commute), group.vehicles - group.not_loaded);
    result.duration_mean = mean(to_seconds(duration), group.finished);
    result.depart_delay_mean = mean(to_seconds(depart_delay), group.finished);
    result.time_loss_mean = mean(to_seconds(time_loss), group.finished);
    result.route_length_mean = mean(route_length, group.finished);
    return result;
  }
};

template <class Source>
void read_trips_from(const Source& source, std::span<const DemandedTrip> demand, Millis end,
                     RunSummary& run) {
  run.unknown = 0;
  run.reroutes = 0;
  TripReader reader(demand, run);
  source(reader);
  Sums all;
  Sums fixed;
  Sums equipped;
  Sums unequipped;
  for (std::size_t i = 0; i < demand.size(); ++i) {
    all.add(demand[i], reader.trips()[i], end);
    Sums& part = demand[i].fixed ? fixed : demand[i].equipped ? equipped : unequipped;
    part.add(demand[i], reader.trips()[i], end);
  }
  run.all = all.means();
  run.all.vehicles += run.dropped;
  run.fixed = fixed.means();
  run.equipped = equipped.means();
  run.unequipped = unequipped.means();
  run.end_s = to_seconds(end);
}

class StatisticsReader final : public xml::Handler {
 public:
  explicit StatisticsReader(Teleports& teleports) : teleports_(teleports) {}

  void start(const xml::Element& element) override {
    if (element.name() != "teleports") return;
    seen_ = true;
    teleports_.jam = count(element, "jam");
    teleports_.yield = count(element, "yield");
    teleports_.wrong_lane = count(element, "wrongLane");
    const auto total = count(element, "total");
    const auto others = teleports_.jam + teleports_.yield + teleports_.wrong_lane;
    if (total < others) throw element.error("the total is less than its parts");
    teleports_.collision = total - others;
  }

  void check(const std::string& name) const {
    if (!seen_) throw InputError(name + ": no <teleports>: this is no statistic output of SUMO");
  }

 private:
  static std::uint64_t count(const xml::Element& element, std::string_view attribute) {
    const auto value = parse_integer<std::uint64_t>(element.require(attribute));
    if (!value) throw element.error("attribute '" + std::string(attribute) + "' is no count");
    return *value;
  }

  Teleports& teleports_;
  bool seen_ = false;
};

}  // namespace

void read_trips(const std::filesystem::path& tripinfo, std::span<const DemandedTrip> demand, Millis end,
                RunSummary& run) {
  read_trips_from([&](xml::Handler& handler) { xml::read(tripinfo, handler); }, demand, end, run);
}

void parse_trips(std::string_view tripinfo, const std::string& name, std::span<const DemandedTrip> demand,
                 Millis end, RunSummary& run) {
  read_trips_from([&](xml::Handler& handler) { xml::parse(tripinfo, name, handler); }, demand, end, run);
}

void read_statistics(const std::filesystem::path& statistics, RunSummary& run) {
  StatisticsReader reader(run.teleports);
  xml::read(statistics, reader);
  reader.check(statistics.string());
}

void parse_statistics(std::string_view statistics, const std::string& name, RunSummary& run) {
  StatisticsReader reader(run.teleports);
  xml::parse(statistics, name, reader);
  reader.check(name);
}

}  // namespace thalweg
