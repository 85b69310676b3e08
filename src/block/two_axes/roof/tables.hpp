// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "block/two_axes/lane_states.hpp"
#include "glissade/block/on_building.hpp"

namespace glissade::block_detail::two_axes {

/// Steps of a ring-down, at most: one that is longer is for the scalar scheme, which has its own
/// bounds.
constexpr double most_ring_down_steps = 0x1p20;

/// Nodes of a tile: what one bound covers.
constexpr std::size_t tile_nodes = 64;

/// The roof's acceleration between nodes over its largest at a node, at most.
constexpr double between_nodes = 1.2;

/// A ground motion at its nodes, for all histories under it.
struct GroundNodes {
  double dt_s = 0.0;
  std::size_t quiet = 0;                 ///< the first node from which on it stays at zero
  std::size_t end = 0;                   ///< the last to which a ring-down is followed here
  std::vector<double> nodes;             ///< GroundRows::nodes
  std::array<std::vector<double>, 2> a;  ///< by axis; zeros follow
  std::vector<double> w;                 ///< the same
  std::vector<double> tile_w,
      coming_w;  ///< largest |w|: of a tile, of it and all after it

  explicit GroundNodes(const BuildingGround& ground);
  bool ends_early() const { return static_cast<double>(end - quiet) == most_ring_down_steps; }
  /// Largest |w| of a tile, and of it and all after it.
  double largest_w(std::size_t k) const { return k < tile_w.size() ? tile_w[k] : 0.0; }
  double w_to_come(std::size_t k) const { return k < coming_w.size() ? coming_w[k] : 0.0; }
  double ground(std::size_t axis, std::size_t node) const {
    return node < quiet ? nodes[4 * node + axis] : 0.0;
  }
  double vertical(std::size_t node) const { return node < quiet ? nodes[4 * node + 2] : 0.0; }
};

/// Scaled state of one axis of a building.
struct AxisState {
  double x = 0.0, y = 0.0;
};

/// The free vibration of one axis with the block at rest on it, over whole
/// steps.
class FreeVibration {
 public:
  FreeVibration(double omega_radps, double twice_zeta, double per_mass, double dt_s,
                std::size_t steps);
  AxisState after(std::size_t steps, const AxisState& from) const;
  /// The roof's acceleration after 0 ... 7 steps: x[k] from.x + y[k] from.y.
  const std::array<double, 8>& x_part() const { return x_part_; }
  const std::array<double, 8>& y_part() const { return y_part_; }
  /// No |acceleration| to come is larger.
  double bound(const AxisState& state) const;
  double acceleration(const AxisState& s) const { return -(twice_zeta_ * s.y + s.x) * per_mass_; }
  /// How far an acceleration of this amplitude leaves its chord over a step, at
  /// most.
  double deviation() const { return deviation_; }

 private:
  struct Matrix {
    double xx = 1.0, xy = 0.0, yx = 0.0, yy = 1.0;
  };
  double omega_, twice_zeta_, per_mass_, root_mass_, deviation_;
  std::array<Matrix, tile_nodes> near_;
  std::vector<Matrix> far_;  // tile_nodes steps each
  std::array<double, 8> x_part_{}, y_part_{};
};

/// The roof while the block rests on it from the begin on, for all histories on
/// one building: by axis, at the ground's nodes, with the ground's own
/// factor 1.
struct RestTable {
  std::array<std::vector<double>, 2> x, y;   ///< empty: rigid
  std::array<std::vector<double>, 2> own_a;  ///< empty: rigid
  std::array<const double*, 2> a{};          ///< acceleration; zeros follow
  std::array<std::vector<double>, 2> tile,
      coming;                                    ///< largest |a|: of a tile, of all to come
  std::array<std::vector<double>, 2> deviation;  ///< how far it leaves its chord, by tile
  std::vector<FreeVibration> free;               ///< by axis; empty: the roof is known beforehand
  std::size_t end = 0;  ///< the last node; of modes some time after the record
  /// Of a roof of modes: by node and axis its acceleration over the sample interval after it, as a
  /// power series of row_terms terms in the elapsed fraction. Empty: another roof.
  std::vector<double> rows;
  std::span<const double, row_terms> row(std::size_t axis, std::size_t node) const {
    return std::span<const double, row_terms>(rows.data() + (2 * node + axis) * row_terms,
                                              row_terms);
  }

  /// @param ground, roof the same each time that a table is made again
  void tabulate(const GroundNodes& ground, const Constants<double>& constants, RoofKind roof);
  void tabulate(const GroundNodes& ground, const std::array<Modes, 2>& modes);
  AxisState state(std::size_t axis, std::size_t node) const {
    return {x[axis][node], y[axis][node]};
  }

 private:
  /// One axis of an oscillator.
  /// @return bound of its |acceleration| after the ground has come to rest
  double tabulate_axis(std::size_t axis, const GroundNodes& ground,
                       const Constants<double>& constants);
  double tabulate_axis(std::size_t axis, const GroundNodes& ground, const Modes& modes);
};

/// Nodes after the last, of zeros, that a search may read.
constexpr std::size_t padding = 2 * tile_nodes;

inline std::size_t tiles_of(std::size_t last_node) { return last_node / tile_nodes + 1; }
/// Largest |value| by tile; the node at a tile's end counts for it too.
std::vector<double> tile_maxima(const double* values, std::size_t last_node);
/// Of each and all after it, the last followed by `after`.
std::vector<double> suffix_maxima(std::vector<double> values, double after);
/// An interval that ends at a tile's first node counts for it too.
void add_interval_before(std::vector<double>& by_tile);

}  // namespace glissade::block_detail::two_axes
