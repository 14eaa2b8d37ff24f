// SPDX-License-Identifier: Apache-2.0
#include "report/gap.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "support/ascii_network.hpp"
#include "support/input_error.hpp"
#include "support/temporary_folder.hpp"
#include "traffic/recorded_times.hpp"

namespace thalweg::testing {
namespace {

//     S-A-B-T      10 s a road when empty
//       | |
//       C-D
class Gap : public ::testing::Test {
 protected:
  /// Each text is an interval of 300 s: "AB 100,CD 20"; "AB 100 40" is with the seconds that were driven
  /// there.
  std::filesystem::path edge_data(const std::vector<std::string>& intervals) {
    std::string text = "<meandata>";
    for (std::size_t i = 0; i < intervals.size(); ++i) {
      text += fmt::format("<interval begin='{}' end='{}' id='x'>", 300 * i, 300 * (i + 1));
      for (const auto entry : split(intervals[i], ",")) {
        const auto words = split(entry, " ");
        const auto driven = words.size() > 2 ? fmt::format(" sampledSeconds='{}'", words[2]) : std::string();
        text += fmt::format("<edge id='{}' traveltime='{}'{}/>", words[0], words[1], driven);
      }
      text += "</interval>";
    }
    return folder.write("edgedata.xml", text + "</meandata>");
  }
  RelativeGap gap_of(const std::string& vehicles, const std::vector<std::string>& intervals) {
    const auto times = edge_data(intervals);
    return relative_gap(folder.write("vehroutes.xml", "<routes>" + vehicles + "</routes>"), times, net,
                        demand);
  }
  static std::string vehicle(const std::string& id, int depart, const std::string& route,
                             const std::string& more = "") {
    return fmt::format("<vehicle id='{}' depart='{}' arrival='900'><route edges='{}'/>{}</vehicle>", id,
                       depart, route, more);
  }

  Network net = ascii_network("S-A-B-T\n  | |\n  C-D");
  Demand demand{.vehicles = IdVector<VehicleId, DemandVehicle>{}, .dropped = {}};
  TemporaryFolder folder;

  void SetUp() override {
    for (const char* id : {"a", "b", "bus", "by"}) {
      demand.vehicles.push_back({});
      demand.vehicles[VehicleId{demand.vehicles.size() - 1}].id = id;
    }
    demand.vehicles[VehicleId{2U}].fixed = true;
    demand.vehicles[VehicleId{3U}].via = {road(net, "CD")};
  }
};

TEST_F(Gap, IsTheTimeLostAgainstTheFastestWay) {
  const auto gap = gap_of(vehicle("a", 0, "SA AB BT") + vehicle("b", 0, "SA AC CD DB BT"), {"AB 100"});
  EXPECT_EQ(gap.trips, 2U);
  EXPECT_DOUBLE_EQ(gap.own_s, 120 + 50);
  EXPECT_DOUBLE_EQ(gap.best_s, 50 + 50);
  EXPECT_DOUBLE_EQ(gap.relative(), 0.7);
  EXPECT_EQ(gap.gaining, 1U);
}

TEST_F(Gap, LooksAtTheTimesOfTheMomentOfEntering) {
  const std::vector<std::string> times{"AB 100", "AB 10", "AB 10"};
  EXPECT_DOUBLE_EQ(gap_of(vehicle("a", 0, "SA AB BT"), times).relative(), 1.4);
  EXPECT_DOUBLE_EQ(gap_of(vehicle("a", 700, "SA AB BT"), times).relative(), 0);
}

TEST_F(Gap, OnlyWhatACarCouldChooseCounts) {
  const std::string of_others = vehicle("bus", 0, "SA AB BT") + vehicle("nobody", 0, "SA AB BT") +
                                vehicle("b", 0, "SA AB BT", "<stop lane='AB_0'/>") +
                                "<vehicle id='a' depart='0'><route edges='SA AB BT'/></vehicle>";
  EXPECT_EQ(gap_of(of_others, {"AB 100"}).trips, 0U);
  EXPECT_TRUE(std::isnan(gap_of(of_others, {"AB 100"}).relative()));
  const auto by = gap_of(vehicle("by", 0, "SA AC CD DB BT"), {"CD 100"});
  EXPECT_EQ(by.trips, 1U);
  EXPECT_DOUBLE_EQ(by.relative(), 0) << "AB would be faster, but not by CD";
}

TEST_F(Gap, TheLastOfSeveralRoutesWasDriven) {
  const auto gap = gap_of(
      "<vehicle id='a' depart='0' arrival='90'><routeDistribution>"
      "<route edges='SA AB BT'/><route edges='SA AC CD DB BT'/>"
      "</routeDistribution></vehicle>",
      {"AB 100"});
  EXPECT_DOUBLE_EQ(gap.own_s, 50);
}

TEST_F(Gap, ARecordingThatIsNoneIsAnError) {
  EXPECT_THROW(gap_of("", {}), InputError);
  EXPECT_THROW(gap_of("", {"XY 3"}), InputError);
}

// Whoever leaves later arrives no earlier, whatever was recorded: here the whole oracle.
TEST_F(Gap, RecordedTimesKeepTheOrderOfVehicles) {
  std::mt19937 draw(7);  // NOLINT(cert-msc51-cpp): the same each time
  for (int round = 0; round < 30; ++round) {
    std::vector<std::string> intervals(6);
    for (std::string& interval : intervals) {
      if (draw() % 4 != 0) interval = fmt::format("AB {}", draw() % (draw() % 2 == 0 ? 60 : 5'000));
    }
    const RecordedTimes times(edge_data(intervals), net);
    Millis before = 0;
    for (Millis entry = 0; entry < 2'400'000; entry += 1'000) {
      const Millis left = times.leave(road(net, "AB"), entry, 10'000);
      EXPECT_GE(left, before) << entry;
      EXPECT_GE(left - entry, times.least(road(net, "AB"), 10'000));
      before = left;
    }
  }
}

TEST_F(Gap, RecordedTimesAreThoseOfTheMiddlesOfTheIntervals) {
  const RecordedTimes times(edge_data({"AB 100", "", "AB 40"}), net);
  const auto takes = [&](const char* id, Millis entry) {
    return times.leave(road(net, id), entry, 10'000) - entry;
  };
  EXPECT_EQ(takes("AB", 0), 100'000);
  EXPECT_EQ(takes("AB", 150'000), 100'000);
  EXPECT_EQ(takes("AB", 300'000), 70'000) << "half way";
  EXPECT_EQ(takes("AB", 450'000), 40'000) << "nobody came: the lower median";
  EXPECT_EQ(takes("AB", 5'000'000), 40'000);
  EXPECT_EQ(takes("BT", 0), 10'000);
  EXPECT_EQ(RecordedTimes(edge_data({"AB 3"}), net).leave(road(net, "AB"), 0, 10'000), 10'000)
      << "nobody is faster than free flow";
  EXPECT_EQ(RecordedTimes(edge_data({"AB 9000", "AB 20"}), net).leave(road(net, "AB"), 0, 10'000), 320'000)
      << "who enters in the second interval does not pass";
}

// One waits at the end of AB for 9.5 s of an interval and goes 20 cm: no crossing of four hours.
TEST_F(Gap, AnIntervalThatNobodyCrossedInIsNotRecorded) {
  const RecordedTimes times(edge_data({"AB 13753 9.5", "AB 20 20", "CD 50 49"}), net);
  EXPECT_EQ(times.leave(road(net, "AB"), 0, 10'000), 20'000);
  EXPECT_EQ(times.leave(road(net, "CD"), 700'000, 10'000), 710'000)
      << "its free flow: nobody ever crossed it";
}

}  // namespace
}  // namespace thalweg::testing
