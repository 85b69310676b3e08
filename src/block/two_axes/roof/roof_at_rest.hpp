// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "block/two_axes/roof/rest_search.hpp"
#include "block/two_axes/roof/roof_piece.hpp"
#include "block/two_axes/roof/tables.hpp"

namespace glissade::block_detail::two_axes {

/// The roof under a block at rest, from a node on: what the building's table
/// gives, and beside it a free vibration of a building that has a state. After the last sample that
/// is not zero, the free vibration alone. The table of modes goes on and ends with a bound.
class RoofAtRest {
 public:
  RoofAtRest(const SceneConstants& constants, RoofKind roof, const GroundNodes& ground,
             const RestTable& table, const HistoryState& state);

  RoofState state(std::size_t node) const;
  /// Nothing is known of the roof before this node.
  std::size_t base() const { return base_; }
  bool after_record() const { return after_record_; }
  /// At node `quiet` of the ground, where only the free vibration is left.
  void end_record();
  /// The bounds from this node on; after the record, the state too.
  void renew(std::size_t node);

  /// The block sticks from this node on, whatever is still to come.
  bool sticks_from(std::size_t node) const;
  /// The block sticks from this node to `tile_end`.
  bool sticks_in_tile(std::size_t node) const;
  std::size_t tile_end(std::size_t node) const;
  /// The roof's acceleration by axis at the nodes from one on, a tile's at least.
  using TileNodes = std::array<double, tile_nodes + 8>;
  std::array<TileNodes, 2> accelerations(std::size_t node) const;
  /// Its largest |value| by axis from a node to `tile_end`.
  std::array<double, 2> bound_in_tile(std::size_t node) const;
  /// By how much it leaves its chord in the tile of a node, at most.
  double deviation(std::size_t axis, std::size_t node) const;
  /// The first node, up to and including `end`, where friction might not hold the block, or a
  /// spring might yield, in the interval before or after it; or end + 1.
  std::size_t first_release(std::size_t from, std::size_t end) const;

 private:
  bool vibrates() const { return has_state(roof_); }
  /// The block sticks whatever the roof does within these bounds.
  bool sticks(const std::array<double, 2>& a, double w) const;
  bool stays_elastic(const auto& largest) const;
  double factor(std::size_t axis) const {
    return axis == 0 ? constants_.factor_1 : constants_.factor_2;
  }
  /// As RestTable's, of all axes.
  RoofState in_table(std::size_t node) const;
  RoofState free_at(std::size_t node) const;
  void set_free(std::size_t node, const RoofState& state);
  void set_bounds(const RoofState& free);

  const SceneConstants& constants_;
  RoofKind roof_;
  const GroundNodes& ground_;
  const RestTable& table_;
  bool after_record_;
  SpringMotion<double> springs_;
  std::size_t base_;  // node of free_
  RoofState free_{};
  std::array<double, 2> free_bound_{}, free_deviation_{};  // of its acceleration
};

}  // namespace glissade::block_detail::two_axes
