// SPDX-License-Identifier: Apache-2.0
#include "traffic/memory.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "core/dice.hpp"
#include "support/ascii_network.hpp"
#include "support/input_error.hpp"
#include "support/temporary_folder.hpp"
#include "traffic/memory_file.hpp"

namespace thalweg::testing {
namespace {

//     A-B-C
class MemoryOfDays : public ::testing::Test {
 protected:
  [[nodiscard]] LivedTime lived(const char* id, double seconds, double observations = 1) const {
    return {.road = road(net, id), .seconds = seconds, .observations = observations};
  }
  [[nodiscard]] RememberedTrip trip(const char* vehicle, Millis depart) const {
    return {.vehicle = vehicle, .depart = depart, .route = {road(net, "AB"), road(net, "BC")}};
  }
  [[nodiscard]] const RememberedTime& at(std::size_t bin, const char* id) const {
    for (const RememberedTime& time : memory.times.at(bin)) {
      if (time.road == road(net, id)) return time;
    }
    throw std::runtime_error(std::string("nothing is remembered of ") + id);
  }

  Network net = ascii_network("A-B-C");
  Memory memory;
};

// n days of one road: their mean, as long as 1/n is above the least step; then each day counts that much.
TEST_F(MemoryOfDays, IsTheMeanOfTheDaysAndLaterFollowsThem) {
  Dice dice(3);
  std::vector<double> days;
  for (int day = 1; day <= 5; ++day) {
    days.push_back(10 + static_cast<double>(dice.roll(100)));
    memory.learn({{lived("AB", days.back(), 2)}}, {}, 1);
    EXPECT_NEAR(at(0, "AB").seconds, std::accumulate(days.begin(), days.end(), 0.0) / day, 1e-9);
  }
  const double before = at(0, "AB").seconds;
  memory.learn({{lived("AB", before + 50)}}, {}, 1);
  EXPECT_NEAR(at(0, "AB").seconds, before + Memory::least_step * 50, 1e-9);
  EXPECT_EQ(at(0, "AB").days, 6U);
  EXPECT_DOUBLE_EQ(at(0, "AB").observations, 11);
  EXPECT_EQ(memory.days, 6U);
}

TEST_F(MemoryOfDays, WhatADayDoesNotSeeStaysAsItWas) {
  memory.learn({{lived("AB", 10), lived("BC", 30)}, {lived("BC", 7)}}, {}, 1);
  memory.learn({{lived("BC", 50), lived("CB", 5)}}, {}, 1);
  EXPECT_DOUBLE_EQ(at(0, "AB").seconds, 10);
  EXPECT_EQ(at(0, "AB").days, 1U);
  EXPECT_DOUBLE_EQ(at(0, "BC").seconds, 40);
  EXPECT_DOUBLE_EQ(at(0, "CB").seconds, 5) << "the first day that saw it";
  EXPECT_DOUBLE_EQ(at(1, "BC").seconds, 7);
}

TEST_F(MemoryOfDays, TheWaysOfTheBetterDayAreKept) {
  memory.learn({}, {trip("late", 9'000), trip("early", 1'000)}, 100);
  EXPECT_EQ(memory.trips.front().vehicle, "early") << "in the order of departures";
  memory.learn({}, {trip("worse", 0)}, 110);
  EXPECT_EQ(memory.trips.size(), 2U);
  EXPECT_DOUBLE_EQ(memory.commute, 102) << "what they promise is doubted";
  memory.learn({}, {trip("better", 0)}, 101);
  EXPECT_EQ(memory.trips.at(0).vehicle, "better");
  EXPECT_DOUBLE_EQ(memory.commute, 101);
}

class MemoryFile : public MemoryOfDays {
 protected:
  void SetUp() override {
    memory.learn({{lived("AB", 12.5, 3), lived("BC", 30)}, {}, {lived("CB", 7)}},
                 {trip("one & <only>", 1'500), trip("two", 2'000)}, 42.5);
    write_memory(folder.path(), net, memory, "a header");
  }
  /// What reading says once times.xml.gz is this.
  std::string error_of(const std::string& times) {
    folder.write_gzip("times.xml.gz", times);
    return input_error([&] { read_memory(folder.path(), net); });
  }
  static std::string in_memory(const std::string& intervals) {
    return "<memory days='2' bin='60' commute='1'>\n" + intervals + "</memory>";
  }

  TemporaryFolder folder;
};

TEST_F(MemoryFile, ComesBackAsItWas) {
  const Memory back = read_memory(folder.path(), net);
  EXPECT_EQ(back.days, 1U);
  EXPECT_EQ(back.bin, memory.bin);
  EXPECT_DOUBLE_EQ(back.commute, 42.5);
  ASSERT_EQ(back.times.size(), 3U);
  for (std::size_t bin = 0; bin < 3; ++bin) {
    ASSERT_EQ(back.times[bin].size(), memory.times[bin].size());
    for (std::size_t i = 0; i < back.times[bin].size(); ++i) {
      EXPECT_EQ(back.times[bin][i].road, memory.times[bin][i].road);
      EXPECT_DOUBLE_EQ(back.times[bin][i].seconds, memory.times[bin][i].seconds);
      EXPECT_DOUBLE_EQ(back.times[bin][i].observations, memory.times[bin][i].observations);
      EXPECT_EQ(back.times[bin][i].days, 1U);
    }
  }
  ASSERT_EQ(back.trips.size(), 2U);
  EXPECT_EQ(back.trips[0].vehicle, "one & <only>");
  EXPECT_EQ(back.trips[0].depart, 1'500);
  EXPECT_EQ(back.trips[1].route, memory.trips[1].route);
}

TEST_F(MemoryFile, IsFoundDamaged) {
  const std::string whole = read_bytes(folder / "times.xml.gz");
  folder.write("times.xml.gz", whole.substr(0, whole.size() / 2));
  EXPECT_TRUE(contains(input_error([&] { read_memory(folder.path(), net); }), "times.xml.gz"));
  std::filesystem::remove(folder / "times.xml.gz");
  EXPECT_TRUE(contains(input_error([&] { read_memory(folder.path(), net); }), "times.xml.gz"));
}

TEST_F(MemoryFile, EveryVehicleHasARouteAndItsPlaceInTheOrder) {
  const auto error_with = [&](const std::string& vehicles) {
    folder.write_gzip("routes.rou.xml.gz", "<routes>\n" + vehicles + "</routes>");
    return input_error([&] { read_memory(folder.path(), net); });
  };
  const std::string good = "<vehicle id='a' depart='5'><route edges='AB BC'/></vehicle>";
  EXPECT_TRUE(contains(error_with("<vehicle id='b' depart='1'/>"), ":2: the vehicle 'b' has no route"));
  EXPECT_TRUE(contains(error_with("<vehicle id='c' depart='1'><route edges=' '/></vehicle>"), "'c'"));
  EXPECT_TRUE(contains(error_with(good + "<vehicle id='d' depart='4'><route edges='AB'/></vehicle>"),
                       "the order of their departures"));
}

TEST_F(MemoryFile, OfSomethingElseIsNamed) {
  const std::string begin = "<interval begin='0' end='60'>\n";
  EXPECT_TRUE(contains(error_of("<meandata><interval begin='0' end='60'/></meandata>"), "is no memory"));
  EXPECT_TRUE(contains(error_of(in_memory(begin + "<edge id='XY' traveltime='1' observations='1' days='1'/>"
                                                  "</interval>")),
                       "the edge 'XY' is not in the net"));
  EXPECT_TRUE(contains(error_of(in_memory(begin + "<edge id='AB' traveltime='-1' observations='1' days='1'/>"
                                                  "</interval>")),
                       "negative"));
  EXPECT_TRUE(contains(error_of(in_memory("<interval begin='30' end='90'/>")), "bins"));
  EXPECT_TRUE(contains(error_of(in_memory(begin + "</interval>" + begin + "</interval>")), "order"));
  EXPECT_TRUE(contains(error_of("<memory days='-1' bin='60' commute='1'/>"), "days"));
  EXPECT_TRUE(contains(error_of("<memory days='1' bin='0' commute='1'/>"), "bin"));
  folder.write_gzip("times.xml.gz", in_memory(""));
  folder.write_gzip("routes.rou.xml.gz",
                    "<routes><vehicle id='a' depart='1'><route edges='AB XY'/></vehicle></routes>");
  EXPECT_TRUE(
      contains(input_error([&] { read_memory(folder.path(), net); }), "the edge 'XY' is not in the net"));
}

}  // namespace
}  // namespace thalweg::testing
