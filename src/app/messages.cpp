// SPDX-License-Identifier: Apache-2.0
#include "app/messages.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <memory>

#include "core/error.hpp"

namespace thalweg {

std::atomic<bool> stop_requested{false};

namespace {

std::array<std::atomic<int>, 64> children{};

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
std::unique_ptr<std::FILE, CloseFile> log_file;
bool is_verbose = false;
std::size_t progress_width = 0;  ///< of the line that is shown

void clear_progress() {
  if (progress_width > 0) fmt::print(stderr, "\r{:{}}\r", "", progress_width);
  progress_width = 0;
}

void say(std::FILE* stream, std::string_view text) {
  clear_progress();
  for (std::FILE* to : {stream, log_file.get()}) {
    if (to == nullptr) continue;
    std::fwrite(text.data(), 1, text.size(), to);
    std::fflush(to);
  }
}

void on_signal(int signal) {
  stop_requested = true;
  for (const auto& child : children) {
    if (child != 0) kill(child, signal);
  }
}

}  // namespace

void configure_messages(bool verbose, const std::filesystem::path& log) {
  if (!log.empty()) {
    log_file.reset(std::fopen(log.c_str(), "w"));
    verify(log_file != nullptr, fmt::format("cannot write '{}': {}", log.string(), std::strerror(errno)));
  }
  is_verbose = verbose || log_file != nullptr;
}

void warn(std::string_view text) { say(stderr, fmt::format("Warning: {}\n", text)); }

void pass_on(std::string_view text) { say(stderr, text); }

void tell_error(std::string_view text) {
  say(stderr, fmt::format("Error: {}\nQuitting (on error).\n", text));
}

Stage::Stage(std::string_view text) {
  if (is_verbose) say(stdout, fmt::format("{} ... ", text));
}

Stage::~Stage() {
  if (!is_verbose) return;
  const auto taken = std::chrono::steady_clock::now() - start_;
  say(stdout,
      fmt::format("done ({}ms).\n", std::chrono::duration_cast<std::chrono::milliseconds>(taken).count()));
}

ProgressLine::ProgressLine()
    : is_terminal_(isatty(STDERR_FILENO) == 1), start_(std::chrono::steady_clock::now()), last_(start_) {}

ProgressLine::~ProgressLine() { clear_progress(); }

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
  fmt::print(stderr, "\r{:{}}", text, progress_width);
  progress_width = std::max(progress_width, text.size());
  std::fflush(stderr);
}

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  struct sigaction hang_up {};
  sigaction(SIGHUP, nullptr, &hang_up);
  if (hang_up.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);  // ignored: started by nohup
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
