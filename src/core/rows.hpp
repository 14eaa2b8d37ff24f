// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace thalweg {

/// Puts items into rows that lie one after the other: row r is items[first[r]] to before items[first[r + 1]].
/// A counting sort: `for_each` is called twice with a `visit(row, make)` that it calls for all items, both
/// times in the same order, which each row keeps; `make()` gives the item and is only called when it is
/// placed.
template <class Index, class Item, class ForEach>
void fill_rows(std::size_t rows, const ForEach& for_each, std::vector<Index>& first,
               std::vector<Item>& items) {
  first.assign(rows + 1, 0);
  for_each([&](std::size_t row, const auto&) { ++first[row + 1]; });
  for (std::size_t row = 0; row < rows; ++row) first[row + 1] += first[row];
  items.resize(first.back());
  std::vector<Index> next(first.begin(), first.end() - 1);
  for_each([&](std::size_t row, const auto& make) { items[next[row]++] = make(); });
}

}  // namespace thalweg
