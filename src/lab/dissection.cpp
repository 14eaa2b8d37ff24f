// SPDX-License-Identifier: Apache-2.0
#include "lab/dissection.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace thalweg::lab {
namespace {

class Dissection {
 public:
  explicit Dissection(const Digraph& graph)
      : graph_(graph), part_(graph.vertex_count(), 0), level_(graph.vertex_count(), 0) {}

  std::vector<VertexId> run() {
    std::vector<VertexId> all;
    for (std::size_t v = 0; v < graph_.vertex_count(); ++v) all.emplace_back(v);
    // Last comes first: a part's cut is put down, then its halves; the order is turned round at the end.
    std::vector<std::vector<VertexId>> parts{std::move(all)};
    while (!parts.empty()) {
      const std::vector<VertexId> part = std::move(parts.back());
      parts.pop_back();
      split(part, parts);
    }
    std::reverse(order_.begin(), order_.end());
    return std::move(order_);
  }

 private:
  /// Puts the cut of `part` into the order and what is left of it into `parts`.
  void split(const std::vector<VertexId>& part, std::vector<std::vector<VertexId>>& parts) {
    ++mark_;
    for (const VertexId v : part) part_[v] = mark_;
    auto found = levels(part.front());
    for (const VertexId v : found) level_[v] = 0;
    found = levels(found.back());  // again, from a far end
    std::vector<VertexId> rest;    // what the search did not reach: a part of its own
    for (const VertexId v : part) {
      if (level_[v] == 0) rest.push_back(v);
    }
    const std::uint32_t cut = level_[found[found.size() / 2]];
    std::vector<VertexId> near;
    std::vector<VertexId> far;
    for (const VertexId v : found) {
      if (level_[v] == cut) order_.push_back(v);
      if (level_[v] < cut) near.push_back(v);
      if (level_[v] > cut) far.push_back(v);
    }
    for (auto* half : {&rest, &near, &far}) {
      if (!half->empty()) parts.push_back(std::move(*half));
    }
    for (const VertexId v : part) level_[v] = 0;
  }

  std::vector<VertexId> levels(VertexId start) {
    std::vector<VertexId> queue{start};
    level_[start] = 1;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const VertexId u = queue[i];
      const auto meet = [&](const Arc& arc) {
        if (part_[arc.end] != mark_ || level_[arc.end] != 0) return;
        level_[arc.end] = level_[u] + 1;
        queue.push_back(arc.end);
      };
      for (const Arc& arc : graph_.out(u)) meet(arc);
      for (const Arc& arc : graph_.in(u)) meet(arc);
    }
    return queue;
  }

  const Digraph& graph_;
  IdVector<VertexId, std::uint32_t> part_;   ///< the mark of the last part a vertex was in
  IdVector<VertexId, std::uint32_t> level_;  ///< in the search of the present part; 0: not met
  std::uint32_t mark_ = 0;
  std::vector<VertexId> order_;
};

}  // namespace

std::vector<VertexId> dissection_order(const Digraph& graph) {
  if (graph.vertex_count() == 0) return {};
  return Dissection(graph).run();
}

}  // namespace thalweg::lab
