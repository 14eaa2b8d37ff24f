// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <vector>

namespace thalweg {

/// A number that names one thing of one kind. Ids of different kinds do not mix.
/// A default-made id names nothing (`valid()` is false).
template <class Tag>
struct Id {
  std::uint32_t value = std::numeric_limits<std::uint32_t>::max();

  constexpr Id() = default;
  constexpr explicit Id(std::size_t v) : value(static_cast<std::uint32_t>(v)) {}
  [[nodiscard]] constexpr bool valid() const { return value != std::numeric_limits<std::uint32_t>::max(); }
  auto operator<=>(const Id&) const = default;
};

/// A vector that only the id of its own kind may index.
template <class I, class T>
class IdVector {
 public:
  IdVector() = default;
  explicit IdVector(std::size_t size, const T& fill = T{}) : items_(size, fill) {}
  IdVector(std::initializer_list<T> items) : items_(items) {}

  decltype(auto) operator[](I id) {
    assert(id.value < items_.size());
    return items_[id.value];
  }
  decltype(auto) operator[](I id) const {
    assert(id.value < items_.size());
    return items_[id.value];
  }

  [[nodiscard]] std::size_t size() const { return items_.size(); }
  [[nodiscard]] bool empty() const { return items_.empty(); }
  /// The id that the next `push_back` will get.
  [[nodiscard]] I next_id() const { return I{items_.size()}; }
  I push_back(T item) {
    items_.push_back(std::move(item));
    return I{items_.size() - 1};
  }
  void assign(std::size_t size, const T& fill) { items_.assign(size, fill); }
  void resize(std::size_t size) { items_.resize(size); }
  void reserve(std::size_t size) { items_.reserve(size); }

  auto begin() { return items_.begin(); }
  auto end() { return items_.end(); }
  auto begin() const { return items_.begin(); }
  auto end() const { return items_.end(); }
  auto operator<=>(const IdVector&) const = default;

 private:
  std::vector<T> items_;
};

using RoadId = Id<struct RoadTag>;          ///< a road: an edge of the net, internal (junction) ones included
using LaneId = Id<struct LaneTag>;          ///< a lane of a road
using JunctionId = Id<struct JunctionTag>;  ///< a junction of the net
using SignalId = Id<struct SignalTag>;      ///< a traffic light of the net
using ConnectionId = Id<struct ConnectionTag>;  ///< a lane-to-lane connection of the net
using MovementId = Id<struct MovementTag>;      ///< a road and the one that follows it, by whatever lanes
using VertexId = Id<struct VertexTag>;          ///< a vertex of any Digraph
using ArcId = Id<struct ArcTag>;                ///< an arc of any Digraph
using VehicleId = Id<struct VehicleTag>;        ///< a vehicle of the demand, in its order

}  // namespace thalweg

template <class Tag>
struct std::hash<thalweg::Id<Tag>> {
  std::size_t operator()(thalweg::Id<Tag> id) const noexcept { return id.value; }
};
