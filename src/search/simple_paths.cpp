// SPDX-License-Identifier: Apache-2.0
#include "search/simple_paths.hpp"

namespace thalweg {

SimplePaths::SimplePaths(const Digraph& graph, VertexId source, VertexId target, PathLimit limit)
    : graph_(graph), target_(target), limit_(limit), on_path_(graph.vertex_count(), 0) {
  steps_.reserve(graph.vertex_count() + 1);
  path_.reserve(graph.vertex_count());
  if (source == target) {
    on_path_[source] = 1;
    steps_.push_back({.next = nullptr, .end = nullptr, .vertex = source});
  } else {
    enter(source);
  }
}

void SimplePaths::enter(VertexId vertex) {
  on_path_[vertex] = 1;
  const auto arcs = graph_.out(vertex);
  steps_.push_back({.next = arcs.data(), .end = arcs.data() + arcs.size(), .vertex = vertex});
}

bool SimplePaths::advance() {
  if (cut_) return false;
  if (at_target_) {
    at_target_ = false;
    if (!path_.empty()) path_.pop_back();
  }
  const auto arrive = [this] {
    if (paths_ == limit_.max_paths) {
      cut_ = true;
      return false;
    }
    ++paths_;
    at_target_ = true;
    return true;
  };
  while (!steps_.empty()) {
    Step& step = steps_.back();
    if (step.vertex == target_) {  // source and target in one
      steps_.clear();
      return arrive();
    }
    if (step.next == step.end) {
      on_path_[step.vertex] = 0;
      steps_.pop_back();
      if (!path_.empty()) path_.pop_back();
      continue;
    }
    const Arc arc = *step.next++;
    if (on_path_[arc.end] != 0) continue;
    if (arc.end == target_) {
      path_.push_back(arc.id);
      return arrive();
    }
    if (loops_ == limit_.max_loops) {
      cut_ = true;
      return false;
    }
    ++loops_;
    path_.push_back(arc.id);
    enter(arc.end);
  }
  return false;
}

}  // namespace thalweg
