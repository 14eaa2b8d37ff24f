// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <barrier>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace thalweg {

/// Calls work(phase, item, worker) for every item below items(phase) of every phase below `phases`; a phase
/// begins when the one before it is done. worker < `threads` says whose scratch may be used. Items are taken
/// in order but finish in any: `work` writes to the item's own place only, so that the result does not depend
/// on the number of threads. The first exception thrown comes out after all have stopped.
template <class Items, class Work>
void parallel_phases(std::size_t phases, std::size_t threads, Items&& items, Work&& work) {
  std::vector<std::atomic<std::size_t>> next(phases);
  std::atomic<bool> has_failed = false;
  std::exception_ptr failure;
  std::mutex failure_mutex;
  std::barrier phase_end(static_cast<std::ptrdiff_t>(std::max<std::size_t>(threads, 1)));
  const auto loop = [&](std::size_t worker) {
    for (std::size_t phase = 0; phase < phases; ++phase) {
      try {
        const std::size_t end = items(phase);
        for (std::size_t item = next[phase]++; item < end && !has_failed; item = next[phase]++)
          work(phase, item, worker);
      } catch (...) {
        const std::scoped_lock lock(failure_mutex);
        if (!failure) failure = std::current_exception();
        has_failed = true;
      }
      phase_end.arrive_and_wait();
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t worker = 1; worker < threads; ++worker) others.emplace_back(loop, worker);
    loop(0);
  }
  if (failure) std::rethrow_exception(failure);
}

/// One phase of `items` items.
template <class Work>
void parallel_for(std::size_t items, std::size_t threads, Work&& work) {
  parallel_phases(
      1, std::min(threads, items), [&](std::size_t) { return items; },
      [&](std::size_t, std::size_t item, std::size_t worker) { work(item, worker); });
}

}  // namespace thalweg
