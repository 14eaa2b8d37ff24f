// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/comparison.hpp"

namespace thalweg {

/// Columns on a terminal: here one a code point.
std::size_t width_of(std::string_view text);

using Cells = std::vector<std::string>;

/// A title, and below it columns: the labels to the left, all others to the right.
class TextTable {
 public:
  TextTable(std::string title, Cells labels, std::size_t label_width)
      : title_(std::move(title)), labels_(std::move(labels)), label_width_(label_width) {}

  void column(std::string head, Cells cells) {
    cells.insert(cells.begin(), std::move(head));
    columns_.push_back(std::move(cells));
  }

  void print(std::string& out) const;

 private:
  std::string title_;
  Cells labels_;
  std::size_t label_width_;
  std::vector<Cells> columns_{};
};

/// "-" where the value is not finite.
std::string decimals(double value, int digits, bool sign = false);

/// "345.2 ±3.1"; without an interval only the mean.
std::string with_interval(const Estimate& estimate);

/// Counts are whole in one run; a mean over runs may need a decimal.
std::string count_text(double mean);

/// Breaks at blanks, so that no line goes beyond the width; later lines are indented.
std::string wrapped(std::string_view first, std::string_view text);

}  // namespace thalweg
