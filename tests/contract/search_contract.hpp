// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "graph/digraph.hpp"
#include "support/random_graph.hpp"

namespace thalweg::testing {

/// What a search says about one vertex: the cost between it and the root, and the path that has it.
struct Answer {
  Millis label = infinity;
  std::optional<std::vector<ArcId>> path;
};

/// Whether a search is told which vertices are wanted, and may stop when it has them.
enum class Stop : std::uint8_t { at_the_end, when_found };

/// One search as the contract sees it. To put another one under the contract, add it to the list in
/// search_test.cpp.
struct SearchUnderTest {
  std::string name;
  Direction direction;
  bool exact;  ///< finds the least cost; otherwise it may only be above it
  /// One answer for each of `wanted`.
  std::function<std::vector<Answer>(const Instance&, VertexId root, std::span<const VertexId> wanted, Stop)>
      run;

  friend std::ostream& operator<<(std::ostream& out, const SearchUnderTest& search) {
    return out << search.name;
  }
};

/// Every search that has to keep the contract.
std::vector<SearchUnderTest> searches_under_test();

}  // namespace thalweg::testing
