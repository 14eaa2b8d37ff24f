// SPDX-License-Identifier: Apache-2.0
#include "search/region_paths.hpp"

#include <utility>

namespace thalweg {

RegionPaths::RegionPaths(const Digraph& graph, const Regions& regions, VertexId target)
    : graph_(graph), regions_(regions) {
  const std::uint32_t region = regions.number[target];
  if (region == 0) return;
  visits_ = 1;
  path_.resize(region - 1);
  at_source_ = region == 1;
  if (!at_source_) untried_.push_back(graph.in(target));
}

// untried_[h] belongs to a vertex h regions before the target's; path_[length - h - 1] leads into it.
bool RegionPaths::advance() {
  if (at_source_) {
    at_source_ = false;
    return true;
  }
  const std::size_t length = path_.size();
  while (!untried_.empty()) {
    const std::size_t height = untried_.size() - 1;
    auto& untried = untried_.back();
    if (untried.empty()) {
      untried_.pop_back();
      continue;
    }
    const Arc arc = untried.front();
    untried = untried.subspan(1);
    if (regions_.number[arc.end] != length - height) continue;
    path_[length - height - 1] = arc.id;
    ++visits_;
    if (height + 1 == length) return true;
    untried_.push_back(graph_.in(arc.end));
  }
  return false;
}

BigCount count_region_paths(const Digraph& graph, const Regions& regions, VertexId target) {
  const std::uint32_t last = regions.number[target];
  if (last == 0) return 0;
  IdVector<VertexId, std::uint32_t> place(graph.vertex_count());  // of a vertex in its region
  std::vector<BigCount> fore;
  std::vector<BigCount> current(regions.region(1).size(), 1);
  for (std::uint32_t r = 1;; ++r) {
    const auto vertices = regions.region(r);
    for (std::size_t i = 0; i < vertices.size(); ++i) place[vertices[i]] = static_cast<std::uint32_t>(i);
    if (r > 1) {
      current.assign(vertices.size(), 0);
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        for (const Arc& arc : graph.in(vertices[i])) {
          if (regions.number[arc.end] == r - 1) current[i] += fore[place[arc.end]];
        }
      }
    }
    if (r == last) return current[place[target]];
    std::swap(fore, current);
  }
}

}  // namespace thalweg
