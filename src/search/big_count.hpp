// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

namespace thalweg {

/// A number of paths: exact, however large.
using BigCount = boost::multiprecision::cpp_int;

}  // namespace thalweg
