// SPDX-License-Identifier: Apache-2.0
#include "demand/flow.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "demand/vehicle_types.hpp"
#include "support/input_error.hpp"

namespace thalweg::testing {
namespace {

using Attributes = std::vector<std::pair<std::string, std::string>>;

xml::Node flow(Attributes attributes) {
  attributes.insert(attributes.begin(), {{"id", "f"}, {"from", "a"}, {"to", "b"}});
  return {.name = "flow", .attributes = std::move(attributes), .children = {}, .place = "x.xml:1"};
}

std::string departs(const Attributes& attributes, std::uint64_t seed = 1) {
  std::string all;
  for (const xml::Node& one : expand_flow(flow(attributes), seed)) {
    all += (all.empty() ? "" : " ") + one.require("id") + "@" + one.require("depart");
  }
  return all;
}

TEST(Flow, ANumberIsSpreadEvenly) {
  EXPECT_EQ(departs({{"begin", "10"}, {"end", "20"}, {"number", "4"}}),
            "f.0@10.00 f.1@12.50 f.2@15.00 f.3@17.50");
  EXPECT_EQ(departs({{"begin", "1:0:0"}, {"end", "2:0:0"}, {"number", "1"}}), "f.0@3600.00");
  EXPECT_EQ(departs({{"begin", "0"}, {"end", "9"}, {"number", "0"}}), "");
}

TEST(Flow, APeriodOrARateLastsUntilTheEndOrTheNumber) {
  EXPECT_EQ(departs({{"period", "5"}, {"end", "11"}}), "f.0@0.00 f.1@5.00 f.2@10.00");
  EXPECT_EQ(departs({{"period", "5"}, {"end", "10"}}), "f.0@0.00 f.1@5.00");
  EXPECT_EQ(departs({{"period", "5"}, {"number", "2"}}), "f.0@0.00 f.1@5.00");
  EXPECT_EQ(departs({{"vehsPerHour", "1800"}, {"begin", "1"}, {"end", "5"}}), "f.0@1.00 f.1@3.00");
  EXPECT_EQ(departs({{"perHour", "720"}, {"end", "6"}}), "f.0@0.00 f.1@5.00");
}

TEST(Flow, AProbabilityIsThatOfEachSecond) {
  EXPECT_EQ(departs({{"probability", "1"}, {"begin", "3.5"}, {"end", "6"}}), "f.0@3.50 f.1@4.50 f.2@5.50");
  EXPECT_EQ(departs({{"probability", "1"}, {"begin", "3"}, {"number", "2"}}), "f.0@3.00 f.1@4.00");
  EXPECT_EQ(departs({{"probability", "1e-300"}, {"end", "1e9"}}), "");
}

// 4 standard deviations of the counts, whose sums over all seeds are binomial and Poisson.
TEST(Flow, DrawnDeparturesHaveTheirMeanAndTheirSpread) {
  const auto mean_and_variance = [](const Attributes& attributes) {
    constexpr int rounds = 2'000;
    double sum = 0;
    double squares = 0;
    for (std::uint64_t seed = 0; seed < rounds; ++seed) {
      const auto count = static_cast<double>(expand_flow(flow(attributes), seed).size());
      sum += count;
      squares += count * count;
    }
    return std::pair(sum / rounds, squares / rounds - (sum / rounds) * (sum / rounds));
  };
  const auto [seconds, binomial] = mean_and_variance({{"probability", "0.3"}, {"end", "100"}});
  EXPECT_NEAR(seconds, 30, 4 * std::sqrt(21.0 / 2'000));
  EXPECT_NEAR(binomial, 21, 4 * 21 * std::sqrt(2.0 / 2'000));
  const auto [poisson, variance] = mean_and_variance({{"period", "exp(0.3)"}, {"end", "100"}});
  EXPECT_NEAR(poisson, 30, 4 * std::sqrt(30.0 / 2'000));
  EXPECT_NEAR(variance, 30, 4 * 30 * std::sqrt(2.0 / 2'000));
}

TEST(Flow, TheSeedAndTheIdDecideWhatIsDrawn) {
  for (const Attributes& drawn : {Attributes{{"probability", "0.5"}, {"end", "50"}},
                                  Attributes{{"period", "exp(0.5)"}, {"end", "50"}}}) {
    EXPECT_EQ(departs(drawn, 1), departs(drawn, 1));
    EXPECT_NE(departs(drawn, 1), departs(drawn, 2));
    xml::Node other = flow(drawn);
    other.set("id", "g");
    const auto own = expand_flow(flow(drawn), 1);
    const auto others = expand_flow(other, 1);
    const auto same_depart = [](const xml::Node& a, const xml::Node& b) {
      return a.require("depart") == b.require("depart");
    };
    EXPECT_FALSE(std::equal(own.begin(), own.end(), others.begin(), others.end(), same_depart));
  }
}

TEST(Flow, KeepsWhatIsNotItsOwn) {
  const auto expanded =
      expand_flow(flow({{"number", "1"}, {"end", "5"}, {"type", "car"}, {"departLane", "best"}}), 1);
  ASSERT_EQ(expanded.size(), 1U);
  EXPECT_EQ(expanded.front().name, "trip");
  EXPECT_EQ(expanded.front().require("type"), "car");
  EXPECT_EQ(expanded.front().require("departLane"), "best");
  EXPECT_EQ(expanded.front().find("number"), nullptr);
  EXPECT_EQ(expanded.front().find("end"), nullptr);
  EXPECT_EQ(expand_flow(flow({{"number", "1"}, {"end", "5"}, {"route", "r"}}), 1).front().name, "vehicle");
}

TEST(Flow, WhatHasNoEndOrNoValueIsRefused) {
  for (const Attributes& bad :
       {Attributes{}, Attributes{{"number", "3"}}, Attributes{{"period", "3"}},
        Attributes{{"period", "0"}, {"end", "9"}}, Attributes{{"vehsPerHour", "-1"}, {"end", "9"}},
        Attributes{{"probability", "0.5"}}, Attributes{{"probability", "1.5"}, {"end", "9"}},
        Attributes{{"probability", "0"}, {"end", "9"}}, Attributes{{"probability", "nan"}, {"end", "9"}},
        Attributes{{"period", "exp(0.1)"}}, Attributes{{"period", "exp(0)"}, {"end", "9"}},
        Attributes{{"period", "exp(-1)"}, {"end", "9"}}, Attributes{{"period", "exp(often"}, {"end", "9"}},
        Attributes{{"number", "many"}, {"end", "9"}},
        Attributes{{"begin", "soon"}, {"number", "1"}, {"end", "9"}}}) {
    EXPECT_NE(input_error([&] { expand_flow(flow(bad), 1); }).find("x.xml:1"), std::string::npos);
  }
}

xml::Node type(std::string name, Attributes attributes, std::vector<xml::Node> children = {}) {
  return {.name = std::move(name),
          .attributes = std::move(attributes),
          .children = std::move(children),
          .place = "x"};
}

TEST(VehicleTypes, ClassAndSpeedOfAType) {
  VehicleTypes types;
  types.add(type("vType", {{"id", "lorry"}, {"vClass", "truck"}, {"maxSpeed", "20"}}));
  types.add(type("vType", {{"id", "plain"}}));
  ASSERT_NE(types.find("lorry", "v"), nullptr);
  EXPECT_EQ(types.find("lorry", "v")->vehicle_class, VehicleClass::truck);
  EXPECT_EQ(types.find("lorry", "v")->max_speed, 20);
  EXPECT_EQ(types.find("plain", "v")->max_speed, default_max_speed(VehicleClass::passenger));
  EXPECT_EQ(types.find("DEFAULT_BIKETYPE", "v")->vehicle_class, VehicleClass::bicycle);
  EXPECT_EQ(types.find("none", "v"), nullptr);
}

TEST(VehicleTypes, ADistributionGivesEachVehicleItsOwnInItsShares) {
  VehicleTypes types;
  types.add(type("vType", {{"id", "c"}}));
  types.add(type("vTypeDistribution", {{"id", "inner"}},
                 {type("vType", {{"id", "a"}, {"probability", "3"}}), type("vType", {{"id", "b"}})}));
  types.add(type("vTypeDistribution", {{"id", "named"}, {"vTypes", "a c"}, {"probabilities", "0 1"}}));
  int of_a = 0;
  for (int i = 0; i < 1'000; ++i) {
    const std::string vehicle = "v" + std::to_string(i);
    of_a += types.find("inner", vehicle)->id == "a" ? 1 : 0;
    EXPECT_EQ(types.find("inner", vehicle), types.find("inner", vehicle));
    EXPECT_EQ(types.find("named", vehicle)->id, "c");
  }
  EXPECT_GT(of_a, 700);
  EXPECT_LT(of_a, 800);
}

TEST(VehicleTypes, WhatIsNoneIsRefused) {
  VehicleTypes types;
  for (const xml::Node& bad :
       {type("vType", {}), type("vType", {{"id", "x"}, {"vClass", "boat"}}),
        type("vType", {{"id", "x"}, {"maxSpeed", "fast"}}), type("vTypeDistribution", {{"id", "x"}}),
        type("vTypeDistribution", {{"id", "x"}, {"vTypes", "nobody"}})}) {
    EXPECT_FALSE(input_error([&] { types.add(bad); }).empty());
  }
}

}  // namespace
}  // namespace thalweg::testing
