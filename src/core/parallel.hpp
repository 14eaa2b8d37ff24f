// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace thalweg {

/// Calls work(item, worker) for every item below `items`; worker < `threads` says whose scratch may be used.
/// Items are taken in order but finish in any: `work` writes to the item's own place only, so that the result
/// does not depend on the number of threads. The first exception thrown comes out after all have stopped.
template <class Work>
void parallel_for(std::size_t items, std::size_t threads, Work&& work) {
  if (threads <= 1 || items <= 1) {
    for (std::size_t item = 0; item < items; ++item) work(item, std::size_t{0});
    return;
  }
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto loop = [&](std::size_t worker) {
    try {
      for (std::size_t item = next++; item < items; item = next++) work(item, worker);
    } catch (...) {
      const std::scoped_lock lock(failure_mutex);
      if (!failure) failure = std::current_exception();
      next = items;
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t worker = 1; worker < threads && worker < items; ++worker)
      others.emplace_back(loop, worker);
    loop(0);
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace thalweg
