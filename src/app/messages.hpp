// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>

#include "simulation/simulation.hpp"

namespace thalweg {

/// From here on: whether stages are told, and a file that gets every message as well (none: empty).
/// InputError: it cannot be written.
void configure_messages(bool verbose, const std::filesystem::path& log);

/// "Warning: ..." on the error stream.
void warn(std::string_view text);
/// Text as it is, with its line's end, on the error stream.
void pass_on(std::string_view text);
/// "Error: ..." and "Quitting (on error)." on the error stream.
void tell_error(std::string_view text);

/// "Loading net-file from 'x' ... done (10ms)." when verbose.
class Stage {
 public:
  explicit Stage(std::string_view text);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// A line that is rewritten while a simulation runs: simulated time, vehicles, speed, time left. Messages
/// take its place. Nothing unless the error stream is a terminal. One at a time.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  void show(const Simulation& simulation);
  void show(std::string_view text);

 private:
  bool is_terminal_;
  Millis begin_ = -1;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point last_;
};

/// Set by Ctrl-C (SIGINT), SIGTERM and the end of the terminal (SIGHUP) once `catch_interrupts` was called.
/// The signal goes on to the children that are registered meanwhile.
extern std::atomic<bool> stop_requested;
void catch_interrupts();
void register_child(int pid);
void forget_child(int pid);

}  // namespace thalweg
