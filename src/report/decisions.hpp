// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "simulation/control.hpp"
#include "xml/writer.hpp"

namespace thalweg {

/// Every decision of a run (--decision-output): time, vehicle, old and new route with their costs in seconds,
/// the arrival predicted then and the one that came. A kept way has no newRoute.
class DecisionOutput {
 public:
  DecisionOutput(const std::filesystem::path& file,
                 std::string_view header);  ///< InputError: cannot be written
  void write(const Network& network, const Demand& demand, const RunResult& result);

 private:
  xml::Writer writer_;
};

}  // namespace thalweg
