// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "report/comparison.hpp"
#include "report/table.hpp"

namespace thalweg {
namespace {

RunSummary success(std::uint64_t seed, double commute) {
  RunSummary run;
  run.seed = seed;
  run.all = {.vehicles = 1000, .finished = 990, .running = 8, .waiting = 2};
  run.all.commute_mean = commute;
  run.all.duration_mean = commute - 5;
  run.simulation_cpu_s = 12.3;
  return run;
}

RunSummary failure(std::uint64_t seed) {
  RunSummary run;
  run.seed = seed;
  run.exit = 134;
  run.error = "terminate called after throwing an instance of 'std::bad_alloc'";
  return run;
}

Arm arm(const std::string& name, const std::vector<double>& commutes) {
  Arm result{.name = name};
  for (std::size_t i = 0; i < commutes.size(); ++i) result.runs.push_back(success(i + 1, commutes[i]));
  return result;
}

Comparison comparison_of(std::vector<Arm> arms) {
  return {.thalweg = "0.1.0",
          .sumo = "SUMO 1.28.0",
          .configuration = "city.sumocfg",
          .command = "thalweg compare -c city.sumocfg",
          .seeds = {1, 2, 3},
          .arms = std::move(arms)};
}

TEST(Comparison, EveryArmAgainstEveryBaselineThatIsThere) {
  const auto all = differences(comparison_of(
      {arm("static", {100, 110, 120}), arm("device", {90, 99, 111}), arm("evolved", {80, 90, 101})}));
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0].arm, "static");
  EXPECT_EQ(all[0].baseline, "device");
  EXPECT_EQ(all[2].arm, "evolved");
  EXPECT_EQ(all[2].baseline, "static");
  EXPECT_NEAR(all[2].paired.mean, -59.0 / 3, 1e-12);
  EXPECT_NEAR(all[2].relative(), -59.0 / 330, 1e-12);
  EXPECT_TRUE(all[2].paired.differs_from_zero());
  EXPECT_TRUE(differences(comparison_of({arm("evolved", {80})})).empty());
}

TEST(Comparison, FailedRunsCountForNothing) {
  Arm device = arm("device", {90, 99});
  device.runs.push_back(failure(3));
  const auto comparison = comparison_of({arm("static", {100, 110, 500}), device});
  EXPECT_DOUBLE_EQ(commute(comparison.arms[1]).mean, 94.5);
  const auto all = differences(comparison);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[1].paired.count, 2U);
  EXPECT_DOUBLE_EQ(all[1].paired.mean, -10.5);
  EXPECT_DOUBLE_EQ(all[1].baseline_mean, 105);
}

TEST(Comparison, JsonHasTheKeysThatOthersRead) {
  const auto json = to_json(comparison_of({arm("static", {100}), arm("device", {90})}));
  for (const char* key : {"thalweg", "sumo", "configuration", "command", "seeds", "arms", "differences"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  const auto& first = json.at("arms").at(0);
  EXPECT_EQ(first.at("name"), "static");
  EXPECT_EQ(first.at("commute").at("mean"), 100.0);
  EXPECT_TRUE(first.at("commute").at("low").is_null());  // one seed
  const auto& run = first.at("runs").at(0);
  for (const char* key : {"seed", "vehicles", "finished", "running", "waiting", "dropped", "discarded",
                          "not_loaded", "commute_mean", "duration_mean", "depart_delay_mean", "teleports",
                          "reroutes", "wall_s", "router_cpu_s", "simulation_cpu_s", "exit"}) {
    EXPECT_TRUE(run.contains(key)) << key;
  }
  for (const char* key : {"jam", "yield", "wrong_lane", "collision"}) {
    EXPECT_TRUE(run.at("teleports").contains(key)) << key;
  }
  EXPECT_TRUE(run.at("depart_delay_mean").is_null());  // not a number
  const auto& difference = json.at("differences").at(1);
  EXPECT_EQ(difference.at("arm"), "device");
  EXPECT_EQ(difference.at("baseline"), "static");
  EXPECT_EQ(difference.at("mean"), -10.0);
  EXPECT_EQ(difference.at("relative"), -0.1);
  EXPECT_TRUE(difference.at("low").is_null());
  EXPECT_TRUE(difference.at("high").is_null());
}

TEST(Comparison, ARunSurvivesItsFile) {
  RunSummary run = success(18446744073709551615U, 345.678901234567);
  run.arm = "device:period=120";
  run.dropped = 3;
  run.unknown = 4;
  run.teleports = {.jam = 1, .yield = 2, .wrong_lane = 3, .collision = 4};
  run.fixed.vehicles = 12;
  run.equipped.vehicles = 7;
  run.unequipped.commute_mean = 33;
  run.ignored = 9;
  run.gap = {.trips = 4, .gaining = 1, .own_s = 120, .best_s = 100};
  run.forecast_error[2] = {.predictions = 2,
                           .realised = 1800,
                           .own = {.absolute = 60, .difference = -20},
                           .measured = {.absolute = 80, .difference = 10}};
  run.error = "not UTF-8: \xff";
  const auto folder =
      std::filesystem::path(testing::TempDir()) / ("thalweg_report." + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const auto file = folder / "run.json";
  write_json(run, file);
  const RunSummary again = read_run(file);
  EXPECT_EQ(again.arm, run.arm);
  EXPECT_EQ(again.seed, run.seed);
  EXPECT_EQ(again.all.commute_mean, run.all.commute_mean);
  EXPECT_TRUE(std::isnan(again.all.depart_delay_mean));
  EXPECT_EQ(again.fixed.vehicles, 12U);
  EXPECT_EQ(again.teleports.collision, 4U);
  EXPECT_EQ(again.equipped.vehicles, 7U);
  EXPECT_EQ(again.unequipped.commute_mean, 33);
  EXPECT_EQ(again.ignored, 9U);
  EXPECT_EQ(again.gap.relative(), 0.2);
  EXPECT_EQ(again.forecast_error[2].own.difference, -20);
  EXPECT_EQ(to_json(again).dump(), nlohmann::ordered_json::parse(std::ifstream(file)).dump());

  std::ofstream(file) << R"({"arm": "x")";
  EXPECT_THROW(read_run(file), InputError);
  std::ofstream(file) << R"({"arm": "x"})";
  EXPECT_THROW(read_run(file), InputError);
  EXPECT_THROW(read_run(folder / "none.json"), InputError);
  std::filesystem::remove_all(folder);
}

TEST(Table, SaysWhatWasCompared) {
  const auto text =
      format_table(comparison_of({arm("static", {100, 110, 120}), arm("evolved", {80, 90, 101})}));
  EXPECT_TRUE(text.starts_with("SUMO 1.28.0 · seeds 1 to 3 · city.sumocfg")) << text;
  EXPECT_NE(text.find("110.0 ±24.8"), std::string::npos) << text;
  EXPECT_NE(text.find("Mean commute less that of static"), std::string::npos) << text;
  EXPECT_EQ(text.find("Mean commute less that of device"), std::string::npos) << text;
  EXPECT_NE(text.find("Not all trips were finished"), std::string::npos) << text;
}

TEST(Table, NamesTheFailedArmInSumosWords) {
  Arm device{.name = "device"};
  device.runs = {failure(1)};
  auto comparison = comparison_of({arm("static", {100}), device});
  comparison.seeds = {1};
  const auto text = format_table(comparison);
  EXPECT_NE(text.find("device, seed 1, failed (exit 134)"), std::string::npos) << text;
  EXPECT_NE(text.find("std::bad_alloc"), std::string::npos) << text;
  EXPECT_NE(text.find("0 of 1"), std::string::npos) << text;
  EXPECT_NE(text.find("One seed is one observation"), std::string::npos) << text;
}

/// They are SUMO's answer to two things, and switched off by two options.
TEST(Table, TellsTeleportsAfterWaitingFromThoseAfterCollisions) {
  Arm still = arm("static", {100});
  still.runs[0].teleports = {.wrong_lane = 7};
  Arm crashes = arm("forecast", {100});
  crashes.runs[0].teleports = {.collision = 5};
  const auto text = format_table(comparison_of({still, crashes}));
  EXPECT_NE(text.find("Vehicles were teleported (static 7 a run)"), std::string::npos) << text;
  EXPECT_NE(text.find("teleported after collisions (forecast 5 a run)"), std::string::npos) << text;
}

TEST(Table, SaysHowWellArrivalsWerePredicted) {
  Arm forecast = arm("forecast", {100, 110});
  for (RunSummary& run : forecast.runs) {
    run.forecast_error[1] = {.predictions = 10,
                             .realised = 4000,
                             .own = {.absolute = 300, .difference = -80},
                             .measured = {.absolute = 400, .difference = 200}};
  }
  const auto text = format_table(comparison_of({arm("static", {100, 110}), forecast}));
  EXPECT_NE(text.find("forecast        -  30.0 (0.75)"), std::string::npos) << text;
  EXPECT_NE(text.find("    -2.0            +5.0"), std::string::npos) << text;
}

TEST(Table, EquippedAndUnequippedAreShownApartWhereThereAreBoth) {
  Arm forecast = arm("forecast", {100, 110});
  EXPECT_EQ(format_table(comparison_of({forecast})).find("Equipped"), std::string::npos);
  for (RunSummary& run : forecast.runs) {
    run.equipped = {.vehicles = 300, .commute_mean = 90.5};
    run.unequipped = {.vehicles = 700, .commute_mean = 107.5};
  }
  const auto text = format_table(comparison_of({forecast}));
  EXPECT_NE(text.find("90.5"), std::string::npos) << text;
  EXPECT_NE(text.find("107.5"), std::string::npos) << text;
}

TEST(Table, LongNamesGetALineOfTheirOwn) {
  const std::string name = "device:period=120,probability=0.5,threshold.factor=1.1";
  const auto text = format_table(comparison_of({arm("static", {100, 110, 120}), arm(name, {80, 90, 101})}));
  EXPECT_NE(text.find("  [1] " + name + "\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  device:… [1]  "), std::string::npos) << text;
}

}  // namespace
}  // namespace thalweg
