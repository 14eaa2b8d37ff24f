// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "report/trips.hpp"

namespace thalweg {
namespace {

// What SUMO 1.28 writes for each fate of a vehicle, in a run that ended at 300 s. It writes nothing for the
// one discarded by --max-depart-delay, nor for what is due after the end.
constexpr std::string_view finished =
    R"(<tripinfo id="finished" depart="32.00" departLane="B1B2_0" departPos="5.10" departSpeed="13.89"
  departDelay="0.50" arrival="42.00" arrivalLane="B1B2_0" arrivalPos="135.60" arrivalSpeed="14.12"
  duration="10.00" routeLength="130.50" waitingTime="0.00" waitingCount="0" stopTime="0.00" timeLoss="0.54"
  rerouteNo="2" devices="tripinfo_126" vType="DEFAULT_VEHTYPE" speedFactor="1.06" vaporized=""/>)";
constexpr std::string_view running =
    R"(<tripinfo id="running" depart="1.00" departLane="B2A2_0" departPos="5.10" departSpeed="13.10"
  departDelay="0.75" arrival="-1.00" arrivalLane="" arrivalPos="-1.00" arrivalSpeed="-1.00"
  duration="299.00" routeLength="272.69" waitingTime="244.00" waitingCount="6" stopTime="0.00"
  timeLoss="276.58" rerouteNo="0" devices="tripinfo_1" vType="DEFAULT_VEHTYPE" speedFactor="0.94"
  vaporized="end"/>)";
constexpr std::string_view running_on_its_last_road =
    R"(<tripinfo id="last road" depart="2.00" departLane="D3D2_0" departDelay="0.75" arrival="-1.00"
  arrivalLane="" duration="298.00" routeLength="595.73" timeLoss="250.67" rerouteNo="0" vaporized=""/>)";
constexpr std::string_view waiting =
    R"(<tripinfo id="waiting" depart="-1" departLane="" departPos="-1.00" departSpeed="-1.00"
  departDelay="211.50" arrival="-1.00" arrivalLane="" arrivalPos="-1.00" arrivalSpeed="-1.00"
  duration="0.00" routeLength="5.10" waitingTime="0.00" waitingCount="0" stopTime="0.00" timeLoss="0.00"
  rerouteNo="0" devices="tripinfo_354" vType="DEFAULT_VEHTYPE" speedFactor="0.99" vaporized="end"/>)";
constexpr std::string_view due_at_the_end =
    R"(<tripinfo id="at the end" depart="-1" departLane="" departDelay="0.00" arrival="-1.00" arrivalLane=""
  duration="0.00" routeLength="0.00" timeLoss="0.00" rerouteNo="0" vaporized="end"/>)";
constexpr std::string_view crashed =
    R"(<tripinfo id="crashed" depart="1.00" departLane="C1D1_0" departDelay="0.50" arrival="13.00"
  arrivalLane="C1D1_0" duration="12.00" routeLength="129.26" timeLoss="1.88" rerouteNo="0"
  vaporized="collision"/>)";
constexpr std::string_view teleported =
    R"(<tripinfo id="teleported" depart="28.00" departLane="C1C2_0" departDelay="0.75" arrival="233.00"
  arrivalLane="B1C1_0" duration="205.00" routeLength="565.70" timeLoss="441.23" rerouteNo="0"
  vaporized="teleport"/>)";
constexpr std::string_view person =
    R"(<personinfo id="p" depart="15.00" type="DEFAULT_PEDTYPE" duration="20.00" traveltime="20.00">
    <ride waitingTime="0.00" vehicle="finished" depart="15.00" arrival="35.00" duration="20.00"/>
  </personinfo>)";

RunSummary read(std::string_view infos, const std::vector<DemandedTrip>& demand, std::uint64_t dropped = 0) {
  RunSummary run;
  run.dropped = dropped;
  parse_trips("<tripinfos>" + std::string(infos) + "</tripinfos>", "trips", demand, 300'000, run);
  return run;
}

TEST(Trips, FinishedTripCountsItsDelayAndItsDuration) {
  const auto run = read(finished, {{"finished", 31'500}});
  EXPECT_EQ(run.all.finished, 1U);
  EXPECT_DOUBLE_EQ(run.all.commute_mean, 10.5);
  EXPECT_DOUBLE_EQ(run.all.duration_mean, 10);
  EXPECT_DOUBLE_EQ(run.all.depart_delay_mean, 0.5);
  EXPECT_DOUBLE_EQ(run.all.time_loss_mean, 0.54);
  EXPECT_DOUBLE_EQ(run.all.route_length_mean, 130.5);
  EXPECT_EQ(run.reroutes, 2U);
  EXPECT_DOUBLE_EQ(run.end_s, 300);
}

TEST(Trips, UnfinishedTripsCountUntilTheEnd) {
  const std::string infos =
      std::string(running) + std::string(running_on_its_last_road) + std::string(waiting);
  const auto run =
      read(infos, {{"running", 250}, {"last road", 1'250}, {"waiting", 88'500}, {"discarded", 100'000}});
  EXPECT_EQ(run.all.running, 2U);
  EXPECT_EQ(run.all.waiting, 1U);
  EXPECT_EQ(run.all.discarded, 1U);
  EXPECT_DOUBLE_EQ(run.all.commute_mean, (299.75 + 298.75 + 211.5 + 200) / 4);
  EXPECT_TRUE(std::isnan(run.all.duration_mean));
}

TEST(Trips, WhatIsDueAtTheEndOrLaterWasNotLoaded) {
  const auto run = read(due_at_the_end, {{"at the end", 300'000}, {"later", 300'250}});
  EXPECT_EQ(run.all.not_loaded, 2U);
  EXPECT_EQ(run.all.waiting, 0U);
  EXPECT_TRUE(std::isnan(run.all.commute_mean));
}

TEST(Trips, WhoArrivedInALoadedStateWasNotLoaded) {
  const auto run = read(finished, {{.id = "finished", .depart = 31'500, .is_past = true},
                                   {.id = "gone", .depart = 500, .is_past = true}});
  EXPECT_EQ(run.all.finished, 1U);
  EXPECT_EQ(run.all.not_loaded, 1U);
  EXPECT_DOUBLE_EQ(run.all.commute_mean, 10.5);
}

TEST(Trips, RemovedOnTheWayIsDiscarded) {
  const auto run = read(crashed, {{"crashed", 500}});
  EXPECT_EQ(run.all.discarded, 1U);
  EXPECT_DOUBLE_EQ(run.all.commute_mean, 299.5);
}

TEST(Trips, TeleportedToItsDestinationIsFinishedElsewhereDiscarded) {
  EXPECT_EQ(read(teleported, {{"teleported", 27'250, false, "B1C1"}}).all.finished, 1U);
  EXPECT_EQ(read(teleported, {{"teleported", 27'250, false, "C1C0"}}).all.discarded, 1U);
  EXPECT_EQ(read(teleported, {{"teleported", 27'250}}).all.finished, 1U);
}

TEST(Trips, EveryVehicleIsAccountedFor) {
  const std::string infos = std::string(person) + std::string(finished) + std::string(running) +
                            std::string(waiting) + std::string(crashed) + std::string(due_at_the_end);
  const auto run = read(infos,
                        {{"finished", 31'500, true},
                         {"running", 250, false, "", false},
                         {"waiting", 88'500, true},
                         {"crashed", 500},
                         {"at the end", 300'000},
                         {"later", 400'000, true}},
                        7);
  const Group& all = run.all;
  EXPECT_EQ(all.vehicles, 13U);
  EXPECT_EQ(all.vehicles,
            all.finished + all.running + all.waiting + all.discarded + all.not_loaded + run.dropped);
  const Group& fixed = run.fixed;
  EXPECT_EQ(fixed.vehicles, 3U);
  EXPECT_EQ(fixed.finished, 1U);
  EXPECT_EQ(fixed.waiting, 1U);
  EXPECT_EQ(fixed.not_loaded, 1U);
  EXPECT_DOUBLE_EQ(fixed.commute_mean, (10.5 + 211.5) / 2);
  EXPECT_EQ(run.equipped.vehicles, 2U);
  EXPECT_EQ(run.unequipped.vehicles, 1U);
  EXPECT_EQ(run.unequipped.running, 1U);
  EXPECT_EQ(run.unknown, 0U);
}

TEST(Trips, VehiclesNobodyAskedForAreCountedAside) {
  const auto run = read(std::string(finished) + std::string(running), {{"running", 250}});
  EXPECT_EQ(run.unknown, 1U);
  EXPECT_EQ(run.all.vehicles, 1U);
  EXPECT_EQ(run.all.finished, 0U);
}

TEST(Trips, HumanReadableTimes) {
  const auto run = read(R"(
    <tripinfo id="finished" depart="00:00:32" departDelay="00:00:00.50" arrival="00:00:42" arrivalLane="B1B2_0"
      duration="00:00:10" routeLength="130.50" timeLoss="00:00:00.54" rerouteNo="0" vaporized=""/>
    <tripinfo id="running" depart="00:00:01" departDelay="00:00:00.75" arrival="-00:00:01" arrivalLane=""
      duration="00:04:59" routeLength="272.69" timeLoss="00:04:36.58" rerouteNo="0" vaporized="end"/>
    <tripinfo id="waiting" depart="-1" departLane="" departDelay="00:00:21" arrival="-00:00:01"
      arrivalLane="" duration="00:00:00" routeLength="5.10" timeLoss="00:00:00" vaporized="end"/>)",
                        {{"finished", 31'500}, {"running", 250}, {"waiting", 279'000}});
  EXPECT_EQ(run.all.finished, 1U);
  EXPECT_EQ(run.all.running, 1U);
  EXPECT_EQ(run.all.waiting, 1U);
  EXPECT_DOUBLE_EQ(run.all.commute_mean, (10.5 + 299.75 + 21) / 3);
}

TEST(Trips, BrokenFilesAreInputErrors) {
  RunSummary run;
  const std::vector<DemandedTrip> demand{{"finished", 31'500}};
  EXPECT_THROW(read_trips("no/such/tripinfo.xml", demand, 300'000, run), InputError);
  EXPECT_THROW(parse_trips("", "empty", demand, 300'000, run), InputError);
  EXPECT_THROW(parse_trips("<tripinfos>" + std::string(finished), "cut", demand, 300'000, run), InputError);
  EXPECT_THROW(parse_trips("<summary></summary>", "other", demand, 300'000, run), InputError);
}

TEST(Trips, TeleportsByReason) {
  RunSummary run;
  parse_statistics(R"(<statistics>
    <vehicles loaded="1600" inserted="834" running="779" waiting="363"/>
    <teleports total="20" jam="9" yield="6" wrongLane="1"/>
    <personTeleports total="0" abortWait="0" wrongDest="0"/>
  </statistics>)",
                   "statistics", run);
  EXPECT_EQ(run.teleports.jam, 9U);
  EXPECT_EQ(run.teleports.yield, 6U);
  EXPECT_EQ(run.teleports.wrong_lane, 1U);
  EXPECT_EQ(run.teleports.collision, 4U);
  EXPECT_THROW(parse_statistics("<statistics/>", "none", run), InputError);
}

}  // namespace
}  // namespace thalweg
