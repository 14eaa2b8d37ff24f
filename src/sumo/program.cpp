// SPDX-License-Identifier: Apache-2.0
#include "sumo/program.hpp"

#include <fmt/format.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include "core/error.hpp"
#include "sumo/ends_after_us.hpp"

namespace thalweg {
namespace {

namespace bp = boost::process;

template <class Wait>
int run(const std::filesystem::path& program, const std::vector<std::string>& arguments,
        const std::filesystem::path& log, const Wait& wait) {
  try {
    bp::child child(bp::exe = program.string(), bp::args = arguments,
                    bp::std_in<bp::null, (bp::std_out & bp::std_err)> log.string(), ends_after_us(SIGKILL));
    wait(child);
    const int status = child.native_exit_code();
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : child.exit_code();
  } catch (const bp::process_error& error) {
    throw InputError(fmt::format("cannot start '{}': {}", program.string(), error.what()));
  }
}

}  // namespace

int run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                const std::filesystem::path& log) {
  return run(program, arguments, log, [](bp::child& child) { child.wait(); });
}

int run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                const std::filesystem::path& log, const std::atomic<bool>& stop) {
  return run(program, arguments, log, [&](bp::child& child) {
    bool is_told = false;
    while (child.running()) {
      if (stop && !is_told) is_told = kill(child.id(), SIGTERM) == 0;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  });
}

std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return std::move(text).str();
}

}  // namespace thalweg
