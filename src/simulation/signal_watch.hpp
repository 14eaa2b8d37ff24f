// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "routing/strategy.hpp"
#include "simulation/simulation.hpp"

namespace thalweg {

/// Which programme each signal runs, and what those show that follow the traffic.
class SignalWatch {
 public:
  explicit SignalWatch(std::size_t signals) : programmes_(signals) {}

  void look(Simulation& simulation) {
    changed_.clear();
    following_.clear();
    for (std::size_t i = 0; i < programmes_.size(); ++i) {
      const SignalId signal{i};
      const std::string id = simulation.programme_id(signal);
      if (!id.empty() && id != programmes_[signal].id) {
        programmes_[signal] = simulation.programme(signal);
        changed_.push_back(signal);
      }
      if (programmes_[signal].follows_traffic)
        following_.push_back({.signal = signal, .phase = simulation.phase(signal)});
    }
  }

  [[nodiscard]] const IdVector<SignalId, SignalProgramme>& programmes() const { return programmes_; }
  /// At the last look.
  [[nodiscard]] std::span<const SignalId> changed() const { return changed_; }
  [[nodiscard]] std::span<const ShownSignal> following() const { return following_; }

 private:
  IdVector<SignalId, SignalProgramme> programmes_;
  std::vector<SignalId> changed_;
  std::vector<ShownSignal> following_;
};

}  // namespace thalweg
