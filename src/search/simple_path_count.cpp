// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>
#include <unordered_map>
#include <utility>

#include "search/regions.hpp"
#include "search/simple_paths.hpp"

namespace thalweg {
namespace {

// A state has a letter for every slot; a vertex holds a slot while it has both decided and undecided arcs.
// `untouched`: on no piece yet (also a slot that nobody holds). `inner`: within a piece. Otherwise the vertex
// ends a piece whose other end holds the slot letter / 2 - 1, and is its head (wants an arc to leave by) when
// the letter is even, its tail (wants an arc to arrive by) when it is odd.
//
// The search starts with one piece, as if an arc led from the target to the source: a path from source to
// target is a way to close that piece to a cycle with no other piece left.
using State = std::string;
constexpr char untouched = 0;
constexpr char inner = 1;

constexpr char head_of(std::size_t tail_slot) { return static_cast<char>(2 * (tail_slot + 1)); }
constexpr char tail_of(std::size_t head_slot) { return static_cast<char>(2 * (head_slot + 1) + 1); }
constexpr bool ends_piece(char letter) { return letter > inner; }
constexpr bool is_head(char letter) { return ends_piece(letter) && letter % 2 == 0; }
constexpr bool is_tail(char letter) { return ends_piece(letter) && letter % 2 == 1; }
constexpr std::size_t other_end(char letter) { return static_cast<std::size_t>(letter) / 2 - 1; }
/// A letter is a char above 0: more slots than this do not fit, and would be far too many states anyway.
constexpr std::size_t most_slots = 60;

/// The arc from the vertex in slot u to the one in slot v is used. False: it cannot be.
/// `closed` tells that it completed the path; the state is then of no further use.
bool use_arc(State& state, std::size_t u, std::size_t v, bool& closed) {
  const char at_u = state[u];
  const char at_v = state[v];
  if (at_u == inner || at_v == inner || is_tail(at_u) || is_head(at_v)) return false;
  const std::size_t tail = is_head(at_u) ? other_end(at_u) : u;
  const std::size_t head = is_tail(at_v) ? other_end(at_v) : v;
  if (tail == v) {  // this closes a cycle: the path, if no other piece is left
    closed = std::count_if(state.begin(), state.end(), ends_piece) == 2;
    return closed;
  }
  state[u] = inner;
  state[v] = inner;
  state[tail] = tail_of(head);
  state[head] = head_of(tail);
  return true;
}

/// The order in which vertices are finished, and how many slots it takes.
struct Plan {
  std::vector<VertexId> order;
  std::size_t slots = 0;
};

/// At its turn a vertex has all its arcs to later ones decided; then it leaves.
Plan plan(const Digraph& graph, std::vector<VertexId> order, VertexId source, VertexId target) {
  IdVector<VertexId, bool> held(graph.vertex_count(), false);
  std::size_t count = 0;
  Plan out{.order = std::move(order)};
  const auto hold = [&](VertexId v) {
    if (held[v]) return;
    held[v] = true;
    out.slots = std::max(out.slots, ++count);
  };
  IdVector<VertexId, bool> done(graph.vertex_count(), false);
  hold(source);
  hold(target);
  for (const VertexId v : out.order) {
    hold(v);
    for (const Arc& arc : graph.out(v)) {
      if (!done[arc.end]) hold(arc.end);
    }
    for (const Arc& arc : graph.in(v)) {
      if (!done[arc.end]) hold(arc.end);
    }
    done[v] = true;
    --count;
  }
  return out;
}

/// The better one of two orders: by number, and by region from the source.
Plan best_plan(const Digraph& graph, VertexId source, VertexId target) {
  Regions regions;
  partition<Direction::forward>(graph, {&source, 1}, regions);
  std::vector<VertexId> by_number(regions.order);  // what the source does not reach is on no path
  std::sort(by_number.begin(), by_number.end());
  // Arcs from unreached vertices would hold slots: the caller's graph is cut down to the reached part.
  Plan first = plan(graph, std::move(by_number), source, target);
  Plan second = plan(graph, regions.order, source, target);
  return first.slots <= second.slots ? first : second;
}

/// The part of the graph that the source reaches, with new numbers in the old order. Invalid: not in it.
Digraph reached_part(const Digraph& graph, VertexId source, IdVector<VertexId, VertexId>& renamed) {
  Regions regions;
  partition<Direction::forward>(graph, {&source, 1}, regions);
  renamed.assign(graph.vertex_count(), VertexId{});
  std::size_t count = 0;
  for (std::size_t v = 0; v < graph.vertex_count(); ++v) {
    if (regions.number[VertexId{v}] != 0) renamed[VertexId{v}] = VertexId{count++};
  }
  std::vector<ArcEnds> arcs;
  for (std::size_t a = 0; a < graph.arc_count(); ++a) {
    const auto [tail, head] = graph.ends(ArcId{a});
    if (tail == head || !renamed[tail].valid()) continue;
    arcs.push_back({.tail = renamed[tail], .head = renamed[head]});
  }
  return {count, arcs};
}

}  // namespace

std::optional<BigCount> count_simple_paths(const Digraph& whole, VertexId source, VertexId target,
                                           std::size_t max_states) {
  if (source == target) return 1;
  IdVector<VertexId, VertexId> renamed;
  const Digraph graph = reached_part(whole, source, renamed);
  if (!renamed[target].valid()) return 0;
  source = renamed[source];
  target = renamed[target];
  const auto [order, slots] = best_plan(graph, source, target);
  if (slots > most_slots) return std::nullopt;

  constexpr std::size_t nowhere = most_slots;
  IdVector<VertexId, std::size_t> slot(graph.vertex_count(), nowhere);
  std::vector<std::size_t> free_slots;
  for (std::size_t s = slots; s > 0; --s) free_slots.push_back(s - 1);
  const auto hold = [&](VertexId v) {
    if (slot[v] != nowhere) return;
    slot[v] = free_slots.back();
    free_slots.pop_back();
  };
  hold(source);
  hold(target);
  State start(slots, untouched);
  start[slot[source]] = head_of(slot[target]);
  start[slot[target]] = tail_of(slot[source]);

  BigCount found = 0;
  std::unordered_map<State, BigCount> states{{start, 1}};
  std::unordered_map<State, BigCount> next;
  const auto decide = [&](std::size_t u, std::size_t v) {
    next = states;  // without the arc
    for (const auto& [state, count] : states) {
      State with = state;
      bool closed = false;
      if (!use_arc(with, u, v, closed)) continue;
      if (closed) {
        found += count;
      } else {
        next[std::move(with)] += count;
      }
    }
    std::swap(states, next);
    return states.size() <= max_states;
  };
  IdVector<VertexId, bool> done(graph.vertex_count(), false);
  for (const VertexId v : order) {
    hold(v);
    for (const Arc& arc : graph.out(v)) {
      if (done[arc.end]) continue;
      hold(arc.end);
      if (!decide(slot[v], slot[arc.end])) return std::nullopt;
    }
    for (const Arc& arc : graph.in(v)) {
      if (done[arc.end]) continue;
      hold(arc.end);
      if (!decide(slot[arc.end], slot[v])) return std::nullopt;
    }
    next.clear();
    for (auto& [state, count] : states) {  // v leaves: nothing can complete a piece that ends there
      if (ends_piece(state[slot[v]])) continue;
      State without = state;
      without[slot[v]] = untouched;
      next[std::move(without)] += count;
    }
    std::swap(states, next);
    done[v] = true;
    free_slots.push_back(slot[v]);
  }
  return found;
}

std::optional<BigCount> count_simple_path_loops(const Digraph& graph, VertexId source, VertexId target,
                                                std::size_t max_states) {
  if (source == target) return 0;
  std::vector<ArcEnds> arcs;
  for (std::size_t a = 0; a < graph.arc_count(); ++a) {
    const ArcEnds& ends = graph.ends(ArcId{a});
    if (ends.tail != target && ends.head != target) arcs.push_back(ends);
  }
  // The target, now without arcs, serves as the vertex where every path may end.
  for (std::size_t v = 0; v < graph.vertex_count(); ++v) {
    if (VertexId{v} != source && VertexId{v} != target) arcs.push_back({.tail = VertexId{v}, .head = target});
  }
  return count_simple_paths(Digraph(graph.vertex_count(), arcs), source, target, max_states);
}

}  // namespace thalweg
