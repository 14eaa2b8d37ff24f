// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <iterator>
#include <span>

#include "core/id.hpp"

namespace thalweg {

/// Makes an input range of a search that finds one path at a time: `bool advance()` goes to the next one,
/// `path()` shows it. A path's arcs are in driving order and live until the next step.
template <class Search>
class PathRange {
 public:
  class Iterator {
   public:
    using value_type = std::span<const ArcId>;
    using difference_type = std::ptrdiff_t;
    using iterator_concept = std::input_iterator_tag;

    Iterator() = default;
    explicit Iterator(Search* search) : search_(search) { ++*this; }
    value_type operator*() const { return search_->path(); }
    Iterator& operator++() {
      if (!search_->advance()) search_ = nullptr;
      return *this;
    }
    void operator++(int) { ++*this; }
    friend bool operator==(const Iterator& it, std::default_sentinel_t /*end*/) {
      return it.search_ == nullptr;
    }

   private:
    Search* search_ = nullptr;
  };

  /// Takes the first step: call it once.
  Iterator begin() { return Iterator(static_cast<Search*>(this)); }
  [[nodiscard]] std::default_sentinel_t end() const { return {}; }

 private:
  friend Search;
  PathRange() = default;
};

}  // namespace thalweg
