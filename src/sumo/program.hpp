// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

namespace thalweg {

/// Runs a program and waits for it; what it prints goes to `log`. Returns its exit code (128 + n: signal n).
/// InputError when it cannot be started.
int run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                const std::filesystem::path& log);
/// The same for one that may take long: once `stop` is set it is told to end (SIGTERM).
int run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                const std::filesystem::path& log, const std::atomic<bool>& stop);

/// The whole text of a small file; empty when it cannot be read.
std::string read_text(const std::filesystem::path& file);

}  // namespace thalweg
