// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "xml/node.hpp"

namespace thalweg {

/// The trips (or vehicles, when it brings its route) of a <flow>, as SUMO numbers and times them: "id.0",
/// "id.1" .. from `begin` on, a `period` apart, or `number` of them evenly until `end`.
/// Random flows: with `probability` in each second from `begin` on one vehicle or none; with
/// `period="exp(rate)"` times between vehicles are exponential (so is that before the first one), `rate`
/// vehicles a second. What is drawn depends on `seed` and the flow's id only; SUMO draws other numbers.
/// InputError: it has no end, or a value is none.
std::vector<xml::Node> expand_flow(const xml::Node& flow, std::uint64_t seed);

}  // namespace thalweg
