// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <queue>
#include <span>
#include <thread>
#include <utility>
#include <vector>

namespace thalweg {

/// Calls loop(worker) for every worker below `workers` at once, the first of them here, and waits for all.
template <class Loop>
void run_workers(std::size_t workers, const Loop& loop) {
  std::vector<std::jthread> others;
  for (std::size_t worker = 1; worker < workers; ++worker) others.emplace_back(loop, worker);
  loop(std::size_t{0});
}

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
  run_workers(std::min(threads, items), loop);
  if (failure) std::rethrow_exception(failure);
}

/// Calls work(item, worker) for every item of a forest, after all its children; parents[item] > item, or item
/// itself at a root. Of those that may be done the deepest go first, so that what is left at the end is
/// short. Scratch and exceptions as with parallel_for.
template <class Work>
void parallel_tree(std::span<const std::size_t> parents, std::size_t threads, Work&& work) {
  const std::size_t items = parents.size();
  if (threads <= 1 || items <= 1) {
    for (std::size_t item = 0; item < items; ++item) work(item, std::size_t{0});
    return;
  }
  std::vector<std::size_t> depth(items, 0);
  std::vector<std::size_t> children(items, 0);  // that are not done
  for (std::size_t item = items; item-- > 0;) {
    if (parents[item] == item) continue;
    depth[item] = depth[parents[item]] + 1;
    ++children[parents[item]];
  }
  std::priority_queue<std::pair<std::size_t, std::size_t>> ready;  // depth, item
  for (std::size_t item = 0; item < items; ++item) {
    if (children[item] == 0) ready.emplace(depth[item], item);
  }
  std::size_t left = items;
  std::exception_ptr failure;
  std::mutex mutex;
  std::condition_variable news;
  const auto loop = [&](std::size_t worker) {
    std::unique_lock lock(mutex);
    while (true) {
      news.wait(lock, [&] { return !ready.empty() || left == 0; });
      if (left == 0) return;
      const std::size_t item = ready.top().second;
      ready.pop();
      lock.unlock();
      std::exception_ptr own;
      try {
        work(item, worker);
      } catch (...) {
        own = std::current_exception();
      }
      lock.lock();
      if (own) {
        if (!failure) failure = own;
        left = 0;
      } else if (left > 0) {
        --left;
        const std::size_t parent = parents[item];
        if (parent != item && --children[parent] == 0) ready.emplace(depth[parent], parent);
      }
      news.notify_all();
    }
  };
  run_workers(std::min(threads, items), loop);
  if (failure) std::rethrow_exception(failure);
}

}  // namespace thalweg
