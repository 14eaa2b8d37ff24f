// SPDX-License-Identifier: Apache-2.0
#include "search/instance.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace thalweg {

InstanceType instance_type(const Digraph& graph) {
  std::size_t with_reverse = 0;
  IdVector<VertexId, VertexId> leads_to(graph.vertex_count());  // the last u seen with an arc from here to u
  for (std::size_t i = 0; i < graph.vertex_count(); ++i) {
    const VertexId u{i};
    for (const Arc& arc : graph.in(u)) leads_to[arc.end] = u;
    for (const Arc& arc : graph.out(u)) with_reverse += leads_to[arc.end] == u ? 1U : 0U;
  }
  if (with_reverse == graph.arc_count()) return InstanceType::simple;
  return with_reverse == 0 ? InstanceType::directed : InstanceType::mixed;
}

Components strong_components(const Digraph& graph) {
  constexpr auto none = std::numeric_limits<std::uint32_t>::max();
  struct Visit {
    VertexId vertex;
    std::uint32_t next_arc;
  };
  const std::size_t vertices = graph.vertex_count();
  Components out{.number = IdVector<VertexId, std::uint32_t>(vertices, none)};
  IdVector<VertexId, std::uint32_t> found(vertices, none);  // when the vertex was first seen
  IdVector<VertexId, std::uint32_t> low(vertices, none);    // the earliest open vertex known to be reached
  std::vector<VertexId> open;                               // seen, and in no component yet
  std::vector<Visit> visits;                                // the depth-first search's own stack
  std::uint32_t clock = 0;

  const auto enter = [&](VertexId v) {
    found[v] = low[v] = clock++;
    open.push_back(v);
    visits.push_back({.vertex = v, .next_arc = 0});
  };
  const auto close = [&](VertexId v) {
    if (low[v] != found[v]) return;
    VertexId member;
    do {
      member = open.back();
      open.pop_back();
      out.number[member] = out.count;
    } while (member != v);
    ++out.count;
  };

  for (std::size_t i = 0; i < vertices; ++i) {
    if (found[VertexId{i}] != none) continue;
    enter(VertexId{i});
    while (!visits.empty()) {
      auto& [v, next_arc] = visits.back();
      const auto arcs = graph.out(v);
      if (next_arc < arcs.size()) {
        const VertexId head = arcs[next_arc++].end;
        if (found[head] == none) {
          enter(head);
        } else if (out.number[head] == none) {
          low[v] = std::min(low[v], found[head]);
        }
        continue;
      }
      const VertexId done = v;
      visits.pop_back();
      close(done);
      if (!visits.empty()) {
        const VertexId before = visits.back().vertex;
        low[before] = std::min(low[before], low[done]);
      }
    }
  }
  return out;
}

}  // namespace thalweg
