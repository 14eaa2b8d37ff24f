// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <string>

namespace thalweg {

/// A number of paths: exact, however large.
using BigCount = boost::multiprecision::cpp_int;

/// In decimal. (GCC 12 warns of `BigCount::str` where it is inlined.)
[[nodiscard]] std::string digits(BigCount count);

}  // namespace thalweg
