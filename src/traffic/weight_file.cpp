// SPDX-License-Identifier: Apache-2.0
#include "traffic/weight_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "xml/reader.hpp"

namespace thalweg {
namespace {

class WeightHandler : public xml::Handler {
 public:
  WeightHandler(const Network& network, Millis time, RoadTimes& times)
      : network_(network), time_(time), times_(times) {}

  void start(const xml::Element& element) override {
    if (element.name() == "interval") {
      inside_ = element.time("begin") <= time_ && time_ < element.time("end");
      found_ = found_ || inside_;
    } else if (element.name() == "edge" && inside_ && element.find("traveltime")) {
      const auto id = element.require("id");
      const auto road = network_.find_road(id);
      if (!road) throw element.error(fmt::format("the edge '{}' is not in the net", id));
      const double seconds = element.number("traveltime");
      if (seconds < 0) throw element.error("the travel time is negative");
      times_[*road] = std::max(times_[*road], from_seconds(seconds));
    }
  }

  [[nodiscard]] bool found() const { return found_; }

 private:
  const Network& network_;
  Millis time_;
  RoadTimes& times_;
  bool inside_ = false;
  bool found_ = false;
};

}  // namespace

void apply_weight_file(const std::filesystem::path& file, const Network& network, Millis time,
                       RoadTimes& times) {
  WeightHandler handler(network, time, times);
  xml::read(file, handler);
  verify(handler.found(),
         fmt::format("'{}' has no interval that holds the time {} s", file.string(), format_seconds(time)));
}

}  // namespace thalweg
