// SPDX-License-Identifier: Apache-2.0
#include "traffic/recorded_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/error.hpp"
#include "xml/reader.hpp"

namespace thalweg {
namespace {

struct Passing {
  RoadId road;
  std::size_t interval;
  Millis time;
};

class EdgeDataHandler : public xml::Handler {
 public:
  explicit EdgeDataHandler(const Network& network) : network_(network) {}

  void start(const xml::Element& element) override {
    if (element.name() == "interval") {
      const Millis begin = element.time("begin");
      // The last one is cut short where the run ends within it.
      if (!begins.empty() && begin != begins.front() + static_cast<Millis>(begins.size()) * length)
        throw element.error("this interval does not follow the one before");
      if (begins.empty()) length = element.time("end") - begin;
      if (length <= 0) throw element.error("this interval is empty");
      begins.push_back(begin);
    } else if (element.name() == "edge" && element.find("traveltime")) {
      const auto road = network_.find_road(element.require("id"));
      if (begins.empty() || !road) throw element.error("not in an interval, or not in the net");
      // Where less time was driven than one crossing takes, nobody has crossed: the tail of a queue alone
      // makes hours of it.
      const double time = element.number("traveltime");
      if (element.find("sampledSeconds") && element.number("sampledSeconds") < time) return;
      passings.push_back({.road = *road, .interval = begins.size() - 1, .time = from_seconds(time)});
    }
  }

  std::vector<Millis> begins;
  Millis length = 0;
  std::vector<Passing> passings;

 private:
  const Network& network_;
};

}  // namespace

RecordedTimes::RecordedTimes(const std::filesystem::path& edge_data, const Network& network)
    : first_(network.roads.size(), nobody), least_(network.roads.size(), infinity) {
  EdgeDataHandler data(network);
  xml::read(edge_data, data);
  verify(!data.begins.empty(), fmt::format("'{}' has no interval", edge_data.string()));
  begin_ = data.begins.front();
  interval_ = data.length;
  count_ = data.begins.size();
  for (const Passing& passing : data.passings) {
    if (first_[passing.road] == nobody) {
      first_[passing.road] = times_.size();
      times_.resize(times_.size() + count_, infinity);
    }
    times_[first_[passing.road] + passing.interval] = passing.time;
  }
  settle();
}

void RecordedTimes::settle() {
  for (std::size_t i = 0; i < first_.size(); ++i) {
    const RoadId road{i};
    if (first_[road] == nobody) continue;
    Millis* own = times_.data() + first_[road];
    std::vector<Millis> seen;
    std::copy_if(own, own + count_, std::back_inserter(seen), [](Millis t) { return t < infinity; });
    const auto middle = seen.begin() + static_cast<std::ptrdiff_t>((seen.size() - 1) / 2);
    std::nth_element(seen.begin(), middle, seen.end());
    std::replace(own, own + count_, infinity, *middle);
    for (std::size_t k = count_ - 1; k-- > 0;) own[k] = std::min(own[k], own[k + 1] + interval_);
    least_[road] = *std::min_element(own, own + count_);
  }
}

}  // namespace thalweg
