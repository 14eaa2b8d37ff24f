// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace thalweg {

/// Of a connection's `state`: who comes there stops first, then waits for others.
constexpr bool gives_way_after_stop(char state) { return state == 's' || state == 'w' || state == '='; }

/// Who comes there waits for others, without a signal that tells him to.
constexpr bool gives_way(char state) { return state == 'm' || gives_way_after_stop(state); }

}  // namespace thalweg
