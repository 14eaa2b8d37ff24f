// SPDX-License-Identifier: Apache-2.0
#include "demand/flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include "core/dice.hpp"
#include "core/hash.hpp"
#include "core/number.hpp"
#include "core/time.hpp"

namespace thalweg {
namespace {

constexpr std::array<std::string_view, 8> flow_attributes{"begin",       "end",     "number",      "period",
                                                          "vehsPerHour", "perHour", "probability", "id"};

std::optional<Millis> time_of(const xml::Node& flow, std::string_view attribute) {
  const std::string* text = flow.find(attribute);
  if (text == nullptr) return std::nullopt;
  const auto time = parse_time(*text);
  if (!time || *time < 0) throw flow.error(fmt::format("'{}' is no {}", *text, attribute));
  return time;
}

std::optional<std::size_t> number_of(const xml::Node& flow) {
  const std::string* text = flow.find("number");
  if (text == nullptr) return std::nullopt;
  const auto number = parse_integer<std::size_t>(*text);
  if (!number || *number > 100'000'000) throw flow.error(fmt::format("'{}' is no number of vehicles", *text));
  return number;
}

/// A number above 0.
double positive(const xml::Node& flow, std::string_view text, std::string_view what) {
  const auto value = parse_number(text);
  if (!value || *value <= 0) throw flow.error(fmt::format("'{}' is no {} above 0", text, what));
  return *value;
}

/// The time between two vehicles in ms; a fraction matters: 1,000 vehicles an hour are 3.6 s apart, 1,100 are
/// not a whole number of ms.
std::optional<double> period_of(const xml::Node& flow) {
  if (const auto period = time_of(flow, "period")) return static_cast<double>(*period);
  for (const auto* const name : {"vehsPerHour", "perHour"}) {
    if (const std::string* text = flow.find(name)) return 3'600'000.0 / positive(flow, *text, "rate");
  }
  return std::nullopt;
}

/// When the vehicles of a flow depart, one after the other [ms].
class Times {
 public:
  virtual ~Times() = default;
  virtual double next() = 0;
};

class Regular final : public Times {
 public:
  Regular(double begin, double period) : begin_(begin), period_(period) {}
  double next() override { return begin_ + static_cast<double>(count_++) * period_; }

 private:
  double begin_;
  double period_;
  std::size_t count_ = 0;
};

class Exponential final : public Times {
 public:
  Exponential(double begin, double rate, Dice dice) : time_(begin), rate_(rate), dice_(dice) {}
  double next() override { return time_ -= std::log1p(-dice_.unit()) / rate_ * 1000; }

 private:
  double time_;
  double rate_;  ///< 1/s
  Dice dice_;
};

/// The seconds between two successes are geometric: they are drawn, and not second by second.
class EverySecond final : public Times {
 public:
  EverySecond(double begin, double probability, Dice dice)
      : second_(begin), probability_(probability), dice_(dice) {}
  double next() override {
    const double time = second_ + 1000 * std::floor(std::log1p(-dice_.unit()) / std::log1p(-probability_));
    second_ = time + 1000;
    return time;
  }

 private:
  double second_;  ///< the first one that was not asked yet [ms]
  double probability_;
  Dice dice_;
};

std::unique_ptr<Times> times_of(const xml::Node& flow, std::optional<std::size_t> number,
                                std::uint64_t seed) {
  const auto begin = static_cast<double>(time_of(flow, "begin").value_or(0));
  const auto end = time_of(flow, "end");
  const Dice dice(seed, stable_hash(flow.require("id")));
  const std::string_view period_text = flow.value_or("period", "");
  const bool is_exponential = period_text.starts_with("exp(") && period_text.ends_with(')');
  const std::string* probability_text = flow.find("probability");
  if ((is_exponential || probability_text != nullptr) && !number && !end)
    throw flow.error("this flow has no end");
  if (is_exponential) {
    const auto rate = positive(flow, period_text.substr(4, period_text.size() - 5), "rate");
    return std::make_unique<Exponential>(begin, rate, dice);
  }
  if (probability_text != nullptr) {
    const double probability = positive(flow, *probability_text, "probability");
    if (probability > 1) throw flow.error(fmt::format("the probability '{}' is above 1", *probability_text));
    return std::make_unique<EverySecond>(begin, probability, dice);
  }
  auto period = period_of(flow);
  if (!period) {
    if (!number || !end) throw flow.error("this flow has no end: it needs a number, or a period and an end");
    period = *number == 0 ? 0 : (static_cast<double>(*end) - begin) / static_cast<double>(*number);
  }
  if (!number && (!end || *period <= 0)) throw flow.error("this flow has no end");
  return std::make_unique<Regular>(begin, *period);
}

/// What all its vehicles have in common.
xml::Node pattern_of(const xml::Node& flow) {
  xml::Node pattern{.name = "trip", .attributes = {}, .children = flow.children, .place = flow.place};
  for (const auto& [name, value] : flow.attributes) {
    const bool own = std::find(flow_attributes.begin(), flow_attributes.end(), name) != flow_attributes.end();
    if (!own) pattern.attributes.emplace_back(name, value);
  }
  const bool has_route = std::any_of(flow.children.begin(), flow.children.end(),
                                     [](const xml::Node& child) { return child.name == "route"; });
  if (has_route || flow.find("route") != nullptr) pattern.name = "vehicle";
  return pattern;
}

}  // namespace

std::vector<xml::Node> expand_flow(const xml::Node& flow, std::uint64_t seed) {
  const std::string& id = flow.require("id");
  const auto number = number_of(flow);
  const auto times = times_of(flow, number, seed);
  const xml::Node pattern = pattern_of(flow);
  const auto end = static_cast<double>(time_of(flow, "end").value_or(infinity));
  std::vector<xml::Node> expanded;
  for (std::size_t i = 0; !number || i < *number; ++i) {
    const double depart = std::floor(times->next());
    if (!(depart < end)) break;
    xml::Node one = pattern;
    one.set("id", fmt::format("{}.{}", id, i));
    one.set("depart", format_seconds(static_cast<Millis>(depart)));
    expanded.push_back(std::move(one));
  }
  return expanded;
}

}  // namespace thalweg
