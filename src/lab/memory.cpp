// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/dice.hpp"
#include "core/error.hpp"
#include "graph/grid.hpp"
#include "lab/list.hpp"
#include "lab/memory_crew.hpp"

namespace thalweg::lab {
namespace {

constexpr Millis free_cost = 10;
constexpr std::array memories{Memory::none, Memory::own, Memory::shared};

struct Town {
  Digraph grid;
  std::uint64_t hindered_percent = 0;
  std::uint64_t slowdown = 1;
};

struct Setting {
  std::uint64_t vehicles = 0;
  std::uint64_t renewed_percent = 0;
  Millis load = 0;
};

using Days = std::array<std::vector<double>, memories.size()>;  // excess of each memory, day by day, in %

Millis draw_cost(const Town& town, Dice& dice) {
  return dice.roll(100) < town.hindered_percent ? free_cost * static_cast<Millis>(town.slowdown) : free_cost;
}

/// The same town, errands and days for all memories; the measure is a crew that knows every morning what
/// hinders, but not what the others will do.
Days live(const Town& town, const Setting& setting, std::uint64_t days, Dice dice) {
  const std::size_t count = town.grid.vertex_count();
  std::vector<Errand> errands;
  for (std::uint64_t i = 0; i < setting.vehicles; ++i) {
    const std::uint64_t source = dice.roll(count);
    errands.push_back(
        {.source = VertexId{source}, .target = VertexId{(source + 1 + dice.roll(count - 1)) % count}});
  }
  std::vector<Millis> today(town.grid.arc_count());
  for (Millis& cost : today) cost = draw_cost(town, dice);
  const std::vector<Millis> expected(today.size(), free_cost);
  std::vector<MemoryCrew> crews;
  for (const Memory memory : memories) crews.emplace_back(town.grid, errands, expected, memory);
  Days out;
  for (std::uint64_t day = 0; day < days; ++day) {
    if (day > 0) {
      for (Millis& cost : today) {
        if (dice.roll(100) < setting.renewed_percent) cost = draw_cost(town, dice);
      }
    }
    MemoryCrew informed(town.grid, errands, today, Memory::none);
    const auto best = static_cast<double>(informed.drive(today, setting.load));
    for (std::size_t m = 0; m < memories.size(); ++m) {
      const auto cost = static_cast<double>(crews[m].drive(today, setting.load));
      out[m].push_back(100 * (cost / best - 1));
    }
  }
  return out;
}

Report run(const Run& run) {
  const Parameters& given = run.parameters;
  const std::uint64_t side = given.count("size");
  verify_grid(side, 400);
  const auto vehicles = given.list("vehicles", 1);
  const auto greatest = static_cast<double>(*std::max_element(vehicles.begin(), vehicles.end()));
  verify_memory("the crews' minds",
                200 * static_cast<double>(run.threads) * greatest * static_cast<double>(side * side));
  const Town town{.grid = grid_graph(side),
                  .hindered_percent = given.count("hindered"),
                  .slowdown = given.count("slowdown", 1)};
  auto days = given.list("day", 1);
  std::sort(days.begin(), days.end());
  verify(town.hindered_percent <= 100, "--hindered: at most 100 percent");
  Report report{.header = {"vehicles", "renewed a day [%]", "load [cost a vehicle]", "day",
                           "no memory: over informed [%]", "95 % half width, none [%]",
                           "own memory: over informed [%]", "95 % half width, own [%]",
                           "shared memory: over informed [%]", "95 % half width, shared [%]"}};
  for (const std::uint64_t load : given.list("load")) {
    for (const std::uint64_t renewed : given.list("renewed")) {
      verify(renewed <= 100, "--renewed: at most 100 percent");
      for (const std::uint64_t size : vehicles) {
        const Setting setting{size, renewed, static_cast<Millis>(load)};
        std::vector<Days> all(run.repetitions);
        run.repeat(fmt::format("{} vehicles, load {}, renewed {} %", size, load, renewed),
                   [&](std::size_t repetition, std::size_t) {
                     all[repetition] = live(town, setting, days.back(), Dice(run.seed, repetition));
                   });
        for (const std::uint64_t day : days) {
          std::vector<std::string> row{cell(size), cell(renewed), cell(load), cell(day)};
          for (std::size_t m = 0; m < memories.size(); ++m) {
            std::vector<double> excess;
            for (const Days& one : all) excess.push_back(one[m][day - 1]);
            add_estimate(row, estimate(excess), 2);
          }
          report.rows.push_back(std::move(row));
        }
      }
    }
  }
  report.notes.emplace_back(
      "over informed: what the crew's ways cost beyond those of one that knows every morning what hinders, "
      "though not what the others will do");
  return report;
}

}  // namespace

Experiment memory_experiment() {
  return {.name = "memory",
          .summary = "a crew that plans by what its vehicles remember, each for itself or shared",
          .parameters = {{"size", "INT", "8", "Side of the grid; a free road costs 10"},
                         {"vehicles", "LIST", "1,5,20", "Vehicles of the crew"},
                         {"day", "LIST", "1,2,5,10,20", "Days that are reported; the last ends it"},
                         {"hindered", "INT", "20", "Share of the roads that are hindered, in %"},
                         {"slowdown", "INT", "10", "So many times a free road costs a hindered one"},
                         {"renewed", "LIST", "0,5", "Share of the roads drawn again each night, in %"},
                         {"load", "LIST", "0,5", "What each vehicle adds to the road for those after it"}},
          .repetitions = 50,
          .run = run};
}

}  // namespace thalweg::lab
