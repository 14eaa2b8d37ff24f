// SPDX-License-Identifier: Apache-2.0
#include "sumo/program.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <thread>

#include "support/input_error.hpp"
#include "support/temporary_folder.hpp"

namespace thalweg::testing {
namespace {

TEST(Program, ItsExitAndItsWordsComeBack) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_program("/bin/sh", {"-c", "echo out; echo err >&2; exit 3"}, folder / "log"), 3);
  EXPECT_EQ(read_text(folder / "log"), "out\nerr\n");
  EXPECT_EQ(run_program("/bin/sh", {"-c", "kill -KILL $$"}, folder / "log"), 128 + SIGKILL);
  EXPECT_TRUE(contains(input_error([&] { run_program("/no/such", {}, folder / "log"); }), "cannot start"));
}

TEST(Program, ItEndsWhenItIsStopped) {
  const TemporaryFolder folder;
  std::atomic<bool> stop{false};
  std::thread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    stop = true;
  });
  EXPECT_EQ(run_program("/bin/sleep", {"300"}, folder / "log", stop), 128 + SIGTERM);
  later.join();
}

}  // namespace
}  // namespace thalweg::testing
