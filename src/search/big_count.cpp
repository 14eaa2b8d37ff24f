// SPDX-License-Identifier: Apache-2.0
#include "search/big_count.hpp"

#include <algorithm>

namespace thalweg {

std::string digits(BigCount count) {
  std::string out;
  do {
    const auto digit = static_cast<int>(count % 10);
    out.push_back(static_cast<char>('0' + digit));
    count /= 10;
  } while (count > 0);
  std::reverse(out.begin(), out.end());
  return out;
}

}  // namespace thalweg
