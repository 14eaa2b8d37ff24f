// SPDX-License-Identifier: Apache-2.0
#include "app/messages.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>

namespace thalweg {

std::atomic<bool> stop_requested{false};

namespace {

std::array<std::atomic<int>, 64> children{};

void on_signal(int signal) {
  stop_requested = true;
  for (const auto& child : children) {
    if (child != 0) kill(child, signal);
  }
}

}  // namespace

void warn(std::string_view text) { fmt::print(stderr, "Warning: {}\n", text); }

Stage::Stage(bool verbose, std::string_view text) : verbose_(verbose) {
  if (!verbose_) return;
  fmt::print("{} ... ", text);
  std::fflush(stdout);
}

Stage::~Stage() {
  if (!verbose_) return;
  const auto taken = std::chrono::steady_clock::now() - start_;
  fmt::print("done ({}ms).\n", std::chrono::duration_cast<std::chrono::milliseconds>(taken).count());
  std::fflush(stdout);
}

ProgressLine::ProgressLine()
    : is_terminal_(isatty(STDERR_FILENO) == 1), start_(std::chrono::steady_clock::now()), last_(start_) {}

ProgressLine::~ProgressLine() {
  if (width_ > 0) fmt::print(stderr, "\r{:{}}\r", "", width_);
}

void ProgressLine::show(const Simulation& simulation) {
  if (!is_terminal_) return;
  if (begin_ < 0) begin_ = simulation.now();
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < std::chrono::milliseconds(500)) return;
  const double wall = std::chrono::duration<double>(now - start_).count();
  const double simulated = to_seconds(simulation.now() - begin_);
  std::string left;
  if (simulation.end() < infinity && simulated > 0) {
    left = fmt::format(", {:.0f} s left", to_seconds(simulation.end() - simulation.now()) * wall / simulated);
  }
  show(fmt::format("time {} s, {} vehicles, {:.0f} x real time{}", format_seconds(simulation.now()),
                   simulation.running_count(), simulated / wall, left));
}

void ProgressLine::show(std::string_view text) {
  if (!is_terminal_) return;
  last_ = std::chrono::steady_clock::now();
  fmt::print(stderr, "\r{:{}}", text, width_);
  width_ = std::max(width_, text.size());
  std::fflush(stderr);
}

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

void register_child(int pid) {
  for (auto& child : children) {
    int empty = 0;
    if (child.compare_exchange_strong(empty, pid)) return;
  }
}

void forget_child(int pid) {
  for (auto& child : children) {
    int own = pid;
    if (child.compare_exchange_strong(own, 0)) return;
  }
}

}  // namespace thalweg
