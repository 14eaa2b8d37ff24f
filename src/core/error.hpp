// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace thalweg {

/// Something that came from outside is wrong: a file, an option, a program that was called.
/// The message says what, where (file, line, element) and, where it can, what to do. Only main catches it.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws InputError with `message` unless `condition` holds.
inline void verify(bool condition, std::string_view message) {
  if (!condition) throw InputError(std::string(message));
}

}  // namespace thalweg
