// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "cch/order.hpp"

namespace thalweg {

/// Where orders are kept from one process to the next, a file for each graph. An empty folder: nowhere.
struct OrderCache {
  std::filesystem::path folder;
  std::function<void(const std::string&)> warn;  ///< told of a file that is not used, or cannot be written
};

/// `nested_dissection`, taken from the cache where it is there and whole, and put there where it is not. The
/// file is named by the graph's fingerprint and the format's version. Nothing about the cache is an error.
EliminationOrder cached_dissection(const Digraph& graph, std::uint64_t fingerprint, const OrderCache& cache);

}  // namespace thalweg
