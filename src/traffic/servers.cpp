// SPDX-License-Identifier: Apache-2.0
#include "traffic/servers.hpp"

#include <algorithm>
#include <map>

#include "network/lane_targets.hpp"
#include "network/right_of_way.hpp"
#include "traffic/green.hpp"

namespace thalweg {
namespace {

/// Seconds on the internal lanes from this one on.
double through_time(const Network& network, const IdVector<LaneId, LaneId>& next, LaneId via) {
  double seconds = 0;
  for (int parts = 0; via.valid() && parts < 8; ++parts, via = next[via]) {  // a damaged net must not hang us
    seconds += network.lanes[via].length / std::max(0.5, network.lanes[via].speed);
  }
  return seconds;
}

bool leads_from_road_to_road(const Network& network, const Connection& c) {
  return network.roads[c.from].function == RoadFunction::normal &&
         network.roads[c.to].function == RoadFunction::normal;
}

/// How much of the motor traffic may use a lane: cars, only others (buses, trams), nobody but pedestrians and
/// bicycles.
int openness(const Lane& lane) {
  constexpr Permissions on_foot_or_bicycle = [] {
    Permissions set = Permissions::none();
    for (const VehicleClass c :
         {VehicleClass::pedestrian, VehicleClass::wheelchair, VehicleClass::bicycle, VehicleClass::scooter})
      set.add(c);
    return set;
  }();
  if (lane.permissions.allows(VehicleClass::passenger)) return 2;
  return (lane.permissions & on_foot_or_bicycle.complement()) == Permissions::none() ? 0 : 1;
}

}  // namespace

Servers::Servers(const Network& network, const ServerOptions& options)
    : network_(network),
      options_(options),
      means_(network.lanes.size()),
      carries_(network.lanes.size(), false),
      ends_(network.roads.size(), RoadEnd::major),
      free_flow_(network.roads.size(), 0),
      storage_(network.roads.size(), 0),
      fed_by_(network.roads.size()),
      links_(network.signals.size()) {
  measure_roads();
  make_movements();
  find_links();
  find_feeding_signals();
  for (std::size_t i = 0; i < network.roads.size(); ++i) refresh_road(RoadId{i});
  for (std::size_t i = 0; i < network.signals.size(); ++i) {
    const auto& programmes = network.signals[SignalId{i}].programmes;
    if (!programmes.empty()) set_programme(SignalId{i}, programmes.front());
  }
  find_ends();
}

void Servers::measure_roads() {
  for (std::size_t i = 0; i < network_.roads.size(); ++i) {
    const Road& road = network_.roads[RoadId{i}];
    int most = 0;
    double speed = 0;
    for (const LaneId id : road.lanes()) {
      const Lane& lane = network_.lanes[id];
      most = std::max(most, openness(lane));
      speed = std::max(speed, lane.speed);
    }
    for (const LaneId lane : road.lanes()) {
      carries_[lane] = openness(network_.lanes[lane]) == most;
    }
    free_flow_[RoadId{i}] = network_.lanes[road.first_lane].length / std::max(0.1, speed);
  }
}

void Servers::make_movements() {
  IdVector<LaneId, LaneId> next(network_.lanes.size());
  for (const Connection& c : network_.connections) {
    if (network_.roads[c.from].function != RoadFunction::internal) continue;
    next[lane_of(network_, c)] = c.via;
  }
  struct Way {
    std::vector<LaneId> lanes;
    const Connection* first;
    bool carries;  ///< motor traffic, as the road does: what else leads there has no part in it
  };
  std::map<std::pair<RoadId, RoadId>, Way> ways;
  for (const Connection& c : network_.connections) {
    if (!leads_from_road_to_road(network_, c)) continue;
    const LaneId lane = lane_of(network_, c);
    const bool carries = carries_[lane];
    Way& way =
        ways.try_emplace({c.from, c.to}, Way{.lanes = {}, .first = &c, .carries = carries}).first->second;
    if (way.carries && !carries) continue;
    if (carries && !way.carries) way = {.lanes = {}, .first = &c, .carries = true};
    if (std::find(way.lanes.begin(), way.lanes.end(), lane) == way.lanes.end()) way.lanes.push_back(lane);
  }
  first_.assign(network_.roads.size() + 1, 0);
  lane_first_.push_back(0);
  for (const auto& [roads, way] : ways) {
    Movement movement{.from = roads.first, .to = roads.second};
    movement.through = through_time(network_, next, way.first->via);
    const char state = way.first->state;
    const double saturation = options_.saturation_headway;
    movement.gives_way = gives_way(state);
    if (gives_way_after_stop(state)) {
      movement.headway = 2.5 * saturation;
      movement.delay = 4;
    } else if (gives_way(state)) {
      movement.headway = 2 * saturation;
      movement.delay = 2;
    } else {
      movement.headway = saturation;
    }
    movements_.push_back(movement);
    onto_.push_back(movement.to);
    ++first_[roads.first.value + 1];
    lanes_.insert(lanes_.end(), way.lanes.begin(), way.lanes.end());
    lane_first_.push_back(static_cast<std::uint32_t>(lanes_.size()));
  }
  for (std::size_t i = 0; i + 1 < first_.size(); ++i) first_[i + 1] += first_[i];
  signal_waits_ = SignalWaits(movements_.size());
}

void Servers::find_links() {
  for (const Connection& c : network_.connections) {
    if (!c.signal.valid() || !leads_from_road_to_road(network_, c) || c.link_index < 0) continue;
    const MovementId movement = find(c.from, c.to);
    const auto by = lanes(movement);
    if (std::find(by.begin(), by.end(), lane_of(network_, c)) == by.end()) continue;
    links_[c.signal].push_back({.movement = movement, .index = static_cast<std::size_t>(c.link_index)});
  }
}

void Servers::set_programme(SignalId signal, const SignalProgramme& programme) {
  struct Sum {
    double share = 0;
    double delay = 0;
    int links = 0;
  };
  std::map<MovementId, Sum> sums;
  for (const Link& link : links_[signal]) {
    const Green green = green_of(programme, link.index);
    signal_waits_.clear(link.movement);
    if (green.cycle <= 0) continue;  // switched off: as it was
    const double open =
        green.priority + options_.permissive * green.permissive + options_.yellow * green.yellow;
    const double red = std::max(0.0, green.cycle - green.priority - green.permissive - 0.5 * green.yellow);
    Sum& sum = sums[link.movement];
    sum.share += open / green.cycle;
    sum.delay += red * red / (2 * green.cycle);
    ++sum.links;
  }
  for (const auto& [movement, sum] : sums) {
    movements_[movement].headway =
        options_.saturation_headway / std::max(options_.least_share, sum.share / sum.links);
    const double at_any_time = sum.delay / sum.links;
    const auto when_let_in = coordinated(signal, programme, movement);
    movements_[movement].delay = when_let_in.value_or(at_any_time) + 1;
    if (options_.signal_phases && programme.cycle_start && !when_let_in)
      signal_waits_.set(movement, seconds_until_open(programme, links_of(signal, movement)),
                        *programme.cycle_start);
    refresh_road(movements_[movement].from);
  }
}

void Servers::set_cycle_start(SignalId signal, Millis start) {
  for (const Link& link : links_[signal]) signal_waits_.shift(link.movement, start);
}

std::optional<double> Servers::coordinated(SignalId signal, const SignalProgramme& programme,
                                           MovementId movement) const {
  const RoadId road = movements_[movement].from;
  if (fed_by_[road] != signal) return {};
  std::vector<Feeder> feeders;
  for (const Link& link : links_[signal]) {
    const Movement& feeder = movements_[link.movement];
    if (feeder.to == road)
      feeders.push_back({.link = link.index, .travel = feeder.through + free_flow_[road]});
  }
  return coordinated_wait(programme, feeders, links_of(signal, movement), options_.permissive);
}

std::vector<std::size_t> Servers::links_of(SignalId signal, MovementId movement) const {
  std::vector<std::size_t> own;
  for (const Link& link : links_[signal]) {
    if (link.movement == movement) own.push_back(link.index);
  }
  return own;
}

MovementId Servers::find(RoadId from, RoadId to) const {
  for (std::size_t i = first_of(from); i < last_of(from); ++i) {
    if (onto_[i] == to) return MovementId{i};
  }
  return {};
}

void Servers::find_ends() {
  IdVector<RoadId, std::size_t> minor(network_.roads.size(), 0);
  IdVector<RoadId, std::size_t> all(network_.roads.size(), 0);
  for (const Connection& c : network_.connections) {
    if (!carries_[lane_of(network_, c)]) continue;
    ++all[c.from];
    if (gives_way(c.state)) ++minor[c.from];
    if (c.signal.valid() && c.link_index >= 0) ends_[c.from] = RoadEnd::signal;
  }
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    const RoadId road{i};
    if (ends_[road] == RoadEnd::signal || minor[road] == 0) continue;
    ends_[road] = minor[road] == all[road] ? RoadEnd::minor : RoadEnd::mixed;
  }
}

void Servers::find_feeding_signals() {
  IdVector<MovementId, SignalId> by(movements_.size());
  for (std::size_t i = 0; i < links_.size(); ++i) {
    for (const Link& link : links_[SignalId{i}]) by[link.movement] = SignalId{i};
  }
  std::vector<bool> is_fed(fed_by_.size(), false);
  for (std::size_t i = 0; i < movements_.size(); ++i) {
    const RoadId to = movements_[MovementId{i}].to;
    const SignalId signal = by[MovementId{i}];
    fed_by_[to] = is_fed[to.value] && fed_by_[to] != signal ? SignalId{} : signal;
    is_fed[to.value] = true;
  }
}

void Servers::refresh_road(RoadId road) {
  const Road& own = network_.roads[road];
  double room = 0;
  double in_service = 0;
  for (const LaneId lane : own.lanes()) {
    LaneMeans& means = means_[lane] = {};
    int count = 0;
    for (std::size_t m = first_of(road); m < last_of(road); ++m) {
      const auto by = lanes(MovementId{m});
      if (std::find(by.begin(), by.end(), lane) == by.end()) continue;
      means.headway += movements_[MovementId{m}].headway;
      means.delay += movements_[MovementId{m}].delay;
      ++count;
    }
    if (carries_[lane]) room += network_.lanes[lane].length / options_.space;
    if (count == 0) continue;
    means.headway /= count;
    means.delay /= count;
    if (carries_[lane] && means.headway > 0) in_service += 1 + means.delay / means.headway;
  }
  storage_[road] = std::max({options_.least_storage, room, in_service});
}

}  // namespace thalweg
