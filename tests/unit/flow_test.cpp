// SPDX-License-Identifier: Apache-2.0
#include "demand/flow.hpp"

#include <gtest/gtest.h>

#include "demand/vehicle_types.hpp"
#include "support/input_error.hpp"

namespace thalweg::testing {
namespace {

using Attributes = std::vector<std::pair<std::string, std::string>>;

xml::Node flow(Attributes attributes) {
  attributes.insert(attributes.begin(), {{"id", "f"}, {"from", "a"}, {"to", "b"}});
  return {.name = "flow", .attributes = std::move(attributes), .children = {}, .place = "x.xml:1"};
}

std::string departs(const Attributes& attributes) {
  std::string all;
  for (const xml::Node& one : expand_flow(flow(attributes))) {
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

TEST(Flow, KeepsWhatIsNotItsOwn) {
  const auto expanded =
      expand_flow(flow({{"number", "1"}, {"end", "5"}, {"type", "car"}, {"departLane", "best"}}));
  ASSERT_EQ(expanded.size(), 1U);
  EXPECT_EQ(expanded.front().name, "trip");
  EXPECT_EQ(expanded.front().require("type"), "car");
  EXPECT_EQ(expanded.front().require("departLane"), "best");
  EXPECT_EQ(expanded.front().find("number"), nullptr);
  EXPECT_EQ(expanded.front().find("end"), nullptr);
  EXPECT_EQ(expand_flow(flow({{"number", "1"}, {"end", "5"}, {"route", "r"}})).front().name, "vehicle");
}

TEST(Flow, WhatHasNoEndOrIsRandomIsRefused) {
  for (const Attributes& bad :
       {Attributes{}, Attributes{{"number", "3"}}, Attributes{{"period", "3"}},
        Attributes{{"period", "0"}, {"end", "9"}}, Attributes{{"probability", "0.5"}, {"end", "9"}},
        Attributes{{"period", "exp(0.1)"}, {"end", "9"}}, Attributes{{"vehsPerHour", "-1"}, {"end", "9"}},
        Attributes{{"number", "many"}, {"end", "9"}},
        Attributes{{"begin", "soon"}, {"number", "1"}, {"end", "9"}}}) {
    EXPECT_NE(input_error([&] { expand_flow(flow(bad)); }).find("x.xml:1"), std::string::npos);
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
