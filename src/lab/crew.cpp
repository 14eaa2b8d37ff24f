// SPDX-License-Identifier: Apache-2.0
#include "lab/crew.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/dice.hpp"
#include "graph/grid.hpp"
#include "lab/list.hpp"
#include "search/hybrid.hpp"

namespace thalweg::lab {
namespace {

/// The stands of one vehicle, from its entry to its target.
struct Plan {
  std::uint32_t entry = 0;
  std::vector<VertexId> stands{};
};

std::optional<Plan> earliest(const Digraph& graph, const ReserveTable& table, Errand errand,
                             std::uint32_t horizon) {
  // before[step][v]: where it stood a step earlier; v itself when it waited, invalid when it is not there.
  std::vector<IdVector<VertexId, VertexId>> before;
  const VertexId outside{graph.vertex_count()};
  for (std::uint32_t step = 0; step <= horizon; ++step) {
    auto& here = before.emplace_back(graph.vertex_count());
    const auto stand = [&](VertexId at, VertexId from) {
      if (!here[at].valid() && table.is_free(at, step)) here[at] = from;
    };
    if (step > 0) {
      const auto& last = before[step - 1];
      for (std::size_t i = 0; i < graph.vertex_count(); ++i) {
        const VertexId v{i};
        if (!last[v].valid()) continue;
        stand(v, v);
        for (const Arc& arc : graph.out(v)) {
          if (table.may_pass(v, arc.end, step)) stand(arc.end, v);
        }
      }
    }
    stand(errand.source, outside);
    if (!here[errand.target].valid()) continue;
    Plan plan{.entry = step};
    for (VertexId v = errand.target; v != outside; v = before[plan.entry--][v]) plan.stands.push_back(v);
    ++plan.entry;
    std::reverse(plan.stands.begin(), plan.stands.end());
    return plan;
  }
  return std::nullopt;
}

void book(const Plan& plan, ReserveTable& table) {
  for (std::uint32_t i = 0; i < plan.stands.size(); ++i) {
    table.book_stand(plan.stands[i], plan.entry + i);
    if (i > 0) table.book_move(plan.stands[i - 1], plan.stands[i], plan.entry + i);
  }
}

}  // namespace

std::size_t CrewOutcome::arrived() const {
  return static_cast<std::size_t>(
      std::count_if(arrival.begin(), arrival.end(), [](const auto& step) { return step.has_value(); }));
}

CrewOutcome crew_with_table(const Digraph& graph, std::span<const Errand> errands, std::uint32_t horizon) {
  CrewOutcome out;
  ReserveTable table;
  for (const Errand& errand : errands) {
    const auto plan = earliest(graph, table, errand, horizon);
    out.arrival.push_back(std::nullopt);
    if (!plan) continue;
    book(*plan, table);
    out.arrival.back() = plan->entry + static_cast<std::uint32_t>(plan->stands.size()) - 1;
  }
  return out;
}

CrewOutcome crew_without_table(const Digraph& graph, std::span<const Errand> errands, std::uint32_t horizon) {
  struct Vehicle {
    std::vector<VertexId> way;
    std::size_t next = 0;
    bool gone = false;
  };
  std::vector<Vehicle> crew(errands.size());
  for (std::size_t i = 0; i < errands.size(); ++i) {
    Regions regions;
    Tree tree;
    partition<Direction::forward>(graph, {&errands[i].source, 1}, regions);
    hybrid<Direction::forward>(
        graph, regions, [](ArcId) { return 1; }, tree);
    crew[i].way.push_back(errands[i].source);
    const auto arcs = path<Direction::forward>(graph, tree, errands[i].target);
    if (!arcs) {
      crew[i].gone = true;  // it never sets out
      continue;
    }
    for (const ArcId arc : *arcs) crew[i].way.push_back(graph.ends(arc).head);
  }
  CrewOutcome out{.arrival = std::vector<std::optional<std::uint32_t>>(errands.size())};
  IdVector<VertexId, bool> taken(graph.vertex_count(), false);
  for (std::uint32_t step = 0; step <= horizon; ++step) {
    for (std::size_t i = 0; i < crew.size(); ++i) {
      Vehicle& vehicle = crew[i];
      if (vehicle.gone || taken[vehicle.way[vehicle.next]]) continue;
      if (vehicle.next > 0) taken[vehicle.way[vehicle.next - 1]] = false;
      taken[vehicle.way[vehicle.next]] = true;
      if (++vehicle.next < vehicle.way.size()) continue;
      taken[vehicle.way.back()] = false;
      vehicle.gone = true;
      out.arrival[i] = step;
    }
  }
  return out;
}

namespace {

Report run(const Run& run) {
  const std::uint64_t side = run.parameters.count("size");
  const std::uint64_t horizon = run.parameters.count("horizon", 1);
  verify_grid(side, 400);
  verify_memory("the plans",
                4.0 * static_cast<double>(run.threads * side * side) * static_cast<double>(horizon));
  const Digraph grid = grid_graph(side);
  Report report{.header = {"vehicles", "table: arrived [%]", "95 % half width [%]",
                           "table: arrival, mean [steps]", "95 % half width [steps]", "no table: arrived [%]",
                           "95 % half width, none [%]", "no table: everybody arrived [% of crews]"}};
  for (const std::uint64_t size : run.parameters.list("vehicles", 1)) {
    std::vector<double> with(run.repetitions), steps(run.repetitions), without(run.repetitions);
    run.repeat(fmt::format("{} vehicles", size), [&](std::size_t repetition, std::size_t) {
      Dice dice(run.seed ^ size, repetition);
      std::vector<Errand> errands;
      for (std::uint64_t i = 0; i < size; ++i)
        errands.push_back(
            {.source = VertexId{dice.roll(side * side)}, .target = VertexId{dice.roll(side * side)}});
      const auto limit = static_cast<std::uint32_t>(horizon);
      const auto count = static_cast<double>(size);
      const CrewOutcome planned = crew_with_table(grid, errands, limit);
      double sum = 0;
      for (const auto& step : planned.arrival) sum += step.value_or(limit);
      with[repetition] = 100 * static_cast<double>(planned.arrived()) / count;
      steps[repetition] = sum / count;
      without[repetition] =
          100 * static_cast<double>(crew_without_table(grid, errands, limit).arrived()) / count;
    });
    std::vector<std::string> row{cell(size)};
    add_estimate(row, estimate(with), 2);
    add_estimate(row, estimate(steps), 2);
    add_estimate(row, estimate(without), 2);
    const auto whole = std::count(without.begin(), without.end(), 100.0);
    row.push_back(cell(100 * static_cast<double>(whole) / static_cast<double>(run.repetitions), 1));
    report.rows.push_back(std::move(row));
  }
  return report;
}

}  // namespace

Experiment crew_experiment() {
  return {.name = "crew",
          .summary = "a crew in a narrow space, with and without the paper's reserve table",
          .parameters = {{"size", "INT", "8", "Side of the grid; a vertex holds one vehicle"},
                         {"vehicles", "LIST", "2,5,10,20,30,40", "Vehicles of the crew"},
                         {"horizon", "INT", "200", "Steps"}},
          .repetitions = 50,
          .run = run};
}

}  // namespace thalweg::lab
