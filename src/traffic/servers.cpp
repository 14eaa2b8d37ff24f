// SPDX-License-Identifier: Apache-2.0
#include "traffic/servers.hpp"

#include <algorithm>
#include <map>
#include <tuple>

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

/// Of the whole cycle, for one link.
struct Share {
  double green = 0;
  double permissive = 0;
  double yellow = 0;
  double cycle = 0;
};

Share share_of(const SignalProgramme& programme, std::size_t link) {
  Share share;
  for (const SignalPhase& phase : programme.phases) {
    const double seconds = to_seconds(phase.duration);
    share.cycle += seconds;
    if (link >= phase.state.size()) continue;
    switch (phase.state[link]) {
      case 'G':
        share.green += seconds;
        break;
      case 'g':
      case 'o':
      case 'O':
        share.permissive += seconds;
        break;
      case 's':  // a stop, then on
        share.permissive += seconds / 2;
        break;
      case 'y':
      case 'Y':
        share.yellow += seconds;
        break;
      default:
        break;
    }
  }
  return share;
}

}  // namespace

Servers::Servers(const Network& network, const ServerOptions& options)
    : network_(network),
      options_(options),
      means_(network.lanes.size()),
      ends_(network.roads.size(), RoadEnd::major),
      free_flow_(network.roads.size(), 0),
      storage_(network.roads.size(), options.least_storage),
      links_(network.signals.size()) {
  for (std::size_t i = 0; i < network.roads.size(); ++i) {
    const Road& road = network.roads[RoadId{i}];
    double speed = 0;
    double storage = 0;
    for (std::uint32_t k = 0; k < road.lane_count; ++k) {
      const Lane& lane = network.lanes[LaneId{road.first_lane.value + k}];
      speed = std::max(speed, lane.speed);
      storage += lane.length / options.space;
    }
    free_flow_[RoadId{i}] = network.lanes[road.first_lane].length / std::max(0.1, speed);
    storage_[RoadId{i}] = std::max(options.least_storage, storage);
  }
  IdVector<LaneId, LaneId> next(network.lanes.size());
  for (const Connection& c : network.connections) {
    if (network.roads[c.from].function != RoadFunction::internal) continue;
    next[LaneId{network.roads[c.from].first_lane.value + c.from_lane}] = c.via;
  }
  struct Way {
    std::vector<LaneId> lanes;
    const Connection* first;
  };
  std::map<std::pair<RoadId, RoadId>, Way> ways;
  const auto is_normal = [&](RoadId road) { return network.roads[road].function == RoadFunction::normal; };
  for (const Connection& c : network.connections) {
    if (!is_normal(c.from) || !is_normal(c.to)) continue;
    Way& way = ways.try_emplace({c.from, c.to}, Way{.lanes = {}, .first = &c}).first->second;
    const LaneId lane{network.roads[c.from].first_lane.value + c.from_lane};
    if (std::find(way.lanes.begin(), way.lanes.end(), lane) == way.lanes.end()) way.lanes.push_back(lane);
  }
  first_.assign(network.roads.size() + 1, 0);
  lane_first_.push_back(0);
  for (const auto& [roads, way] : ways) {
    Movement movement{.from = roads.first, .to = roads.second};
    movement.through = through_time(network, next, way.first->via);
    const char state = way.first->state;
    const double saturation = options.saturation_headway;
    if (state == 's' || state == 'w' || state == '=') {
      movement.headway = 2.5 * saturation;
      movement.delay = 4;
    } else if (state == 'm') {
      movement.headway = 2 * saturation;
      movement.delay = 2;
    } else {
      movement.headway = saturation;
    }
    movements_.push_back(movement);
    ++first_[roads.first.value + 1];
    lanes_.insert(lanes_.end(), way.lanes.begin(), way.lanes.end());
    lane_first_.push_back(static_cast<std::uint32_t>(lanes_.size()));
  }
  for (std::size_t i = 0; i + 1 < first_.size(); ++i) first_[i + 1] += first_[i];
  for (const Connection& c : network.connections) {
    if (!c.signal.valid() || !is_normal(c.from) || !is_normal(c.to) || c.link_index < 0) continue;
    links_[c.signal].push_back({.movement = find(c.from, c.to), .index = c.link_index});
  }
  for (std::size_t i = 0; i < network.signals.size(); ++i) {
    const auto& programmes = network.signals[SignalId{i}].programmes;
    if (!programmes.empty()) set_programme(SignalId{i}, programmes.front());
  }
  find_ends(network);
  refresh_means(network);
}

void Servers::set_programme(SignalId signal, const SignalProgramme& programme) {
  struct Sum {
    double share = 0;
    double delay = 0;
    int links = 0;
  };
  std::map<MovementId, Sum> sums;
  for (const Link& link : links_[signal]) {
    const Share share = share_of(programme, static_cast<std::size_t>(link.index));
    if (share.cycle <= 0) return;  // switched off: as it was
    const double open = share.green + options_.permissive * share.permissive + options_.yellow * share.yellow;
    const double red = std::max(0.0, share.cycle - share.green - share.permissive - 0.5 * share.yellow);
    Sum& sum = sums[link.movement];
    sum.share += open / share.cycle;
    sum.delay += red * red / (2 * share.cycle);
    ++sum.links;
  }
  for (const auto& [movement, sum] : sums) {
    movements_[movement].headway =
        options_.saturation_headway / std::max(options_.least_share, sum.share / sum.links);
    movements_[movement].delay = sum.delay / sum.links + 1;
  }
  refresh_means(network_);
}

MovementId Servers::find(RoadId from, RoadId to) const {
  for (std::size_t i = first_of(from); i < last_of(from); ++i) {
    if (movements_[MovementId{i}].to == to) return MovementId{i};
  }
  return {};
}

void Servers::find_ends(const Network& network) {
  IdVector<RoadId, std::size_t> minor(network.roads.size(), 0);
  IdVector<RoadId, std::size_t> all(network.roads.size(), 0);
  for (const Connection& c : network.connections) {
    ++all[c.from];
    if (c.state == 'm' || c.state == 's' || c.state == 'w' || c.state == '=') ++minor[c.from];
    if (c.signal.valid() && c.link_index >= 0) ends_[c.from] = RoadEnd::signal;
  }
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    const RoadId road{i};
    if (ends_[road] == RoadEnd::signal || minor[road] == 0) continue;
    ends_[road] = minor[road] == all[road] ? RoadEnd::minor : RoadEnd::mixed;
  }
}

void Servers::refresh_means(const Network& network) {
  means_.assign(network.lanes.size(), {});
  std::vector<int> count(network.lanes.size(), 0);
  for (std::size_t i = 0; i < movements_.size(); ++i) {
    for (const LaneId lane : lanes(MovementId{i})) {
      means_[lane].headway += movements_[MovementId{i}].headway;
      means_[lane].delay += movements_[MovementId{i}].delay;
      ++count[lane.value];
    }
  }
  for (std::size_t i = 0; i < means_.size(); ++i) {
    if (count[i] == 0) continue;
    means_[LaneId{i}].headway /= count[i];
    means_[LaneId{i}].delay /= count[i];
  }
}

}  // namespace thalweg
