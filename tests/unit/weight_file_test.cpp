// SPDX-License-Identifier: Apache-2.0
#include "traffic/weight_file.hpp"

#include <gtest/gtest.h>

#include "support/ascii_network.hpp"
#include "support/input_error.hpp"
#include "support/temporary_folder.hpp"

namespace thalweg::testing {
namespace {

//     A-B-C      10 s each
class WeightFile : public ::testing::Test {
 protected:
  RoadTimes apply(const std::string& intervals, Millis time) {
    RoadTimes times = limit_times(net);
    apply_weight_file(folder.write("w.xml", "<meandata>\n" + intervals + "\n</meandata>"), net, time, times);
    return times;
  }
  TemporaryFolder folder;
  Network net = ascii_network("A-B-C");
};

const std::string two_intervals =
    "<interval begin='0' end='60'><edge id='AB' traveltime='12.5'/><edge id='BC' traveltime='3'/>"
    "<edge id='BA' speed='2'/></interval>"
    "<interval begin='60' end='0:02:00'><edge id='AB' traveltime='40'/></interval>";

TEST_F(WeightFile, TheIntervalOfTheTimeCountsAndNothingIsBelowFreeFlow) {
  const RoadTimes first = apply(two_intervals, 59'999);
  EXPECT_EQ(first[road(net, "AB")], 12'500);
  EXPECT_EQ(first[road(net, "BC")], 10'000);
  EXPECT_EQ(first[road(net, "BA")], 10'000);
  EXPECT_EQ(apply(two_intervals, 60'000)[road(net, "AB")], 40'000);
}

TEST_F(WeightFile, WhatIsWrongIsNamed) {
  const auto error = [&](const std::string& intervals, Millis time) {
    return input_error([&] { apply(intervals, time); });
  };
  EXPECT_TRUE(contains(error(two_intervals, 120'000), "w.xml' has no interval that holds the time 120.00 s"));
  const std::string begin = "<interval begin='0' end='60'>\n";
  EXPECT_TRUE(contains(error(begin + "<edge id='XY' traveltime='1'/></interval>", 0),
                       "w.xml:3: <edge id='XY'>: the edge 'XY' is not in the net"));
  EXPECT_TRUE(contains(error(begin + "<edge id='AB' traveltime='-1'/></interval>", 0),
                       "w.xml:3: <edge id='AB'>: the travel time is negative"));
  EXPECT_TRUE(contains(error(begin + "<edge id='AB' traveltime='nan'/></interval>", 0),
                       "w.xml:3: <edge id='AB'>: traveltime='nan' is not a number"));
}

}  // namespace
}  // namespace thalweg::testing
