// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <complex>
#include <span>
#include <vector>

#include "block/two_axes/lanes/lane_states.hpp"
#include "glissade/block/on_building.hpp"
#include "glissade/core/oscillator.hpp"

namespace glissade::block_detail::two_axes {

/// Steps of a ring-down, at most: one that is longer is for the scalar scheme, which has its own
/// bounds.
constexpr double most_ring_down_steps = 0x1p20;

/// Nodes of a tile: what one bound covers.
constexpr std::size_t tile_nodes = 64;

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

/// Of a building, by axis and mode: ModeMotion, or of one mass LaneMotion's.
using RoofState = std::array<std::array<OscillatorState, most_modes>, 2>;

/// The free vibration of one axis with the block at rest on it, over whole steps; of several modes
/// a part of it (RestModes).
class FreeVibration {
 public:
  FreeVibration(double omega_radps, double twice_zeta, double per_mass, double dt_s,
                std::size_t steps);
  /// x + i y = z, with z' = rate z; x is the roof's acceleration.
  FreeVibration(std::complex<double> rate_per_s, double dt_s, std::size_t steps);
  OscillatorState after(std::size_t steps, const OscillatorState& from) const;
  /// The roof's acceleration after 0 ... 7 steps: x[k] from.x + y[k] from.y.
  const std::array<double, 8>& x_part() const { return x_part_; }
  const std::array<double, 8>& y_part() const { return y_part_; }
  /// The same of the state x.
  const std::array<double, 8>& own_x_part() const { return own_x_part_; }
  const std::array<double, 8>& own_y_part() const { return own_y_part_; }
  /// No |acceleration| to come is larger.
  double bound(const OscillatorState& state) const;
  double acceleration(const OscillatorState& s) const {
    return -(twice_zeta_ * s.y + s.x) * per_mass_;
  }
  /// How far an acceleration of this amplitude leaves its chord over a step, at
  /// most.
  double deviation() const { return deviation_; }

 private:
  struct Matrix {
    double xx = 1.0, xy = 0.0, yx = 0.0, yy = 1.0;
  };
  void repeat(const Matrix& step, std::size_t steps);

  double twice_zeta_, per_mass_, root_mass_, deviation_;
  std::array<Matrix, tile_nodes> near_;
  std::vector<Matrix> far_;  // tile_nodes steps each
  std::array<double, 8> x_part_{}, y_part_{}, own_x_part_{}, own_y_part_{};
};

/// One axis of a building of several modes with the block at rest on it, which couples them: its
/// state is the sum of vibrations that each go on by themselves, z_k' = rate_k z_k + per_ground_k
/// a_ground, and the roof's acceleration is sum of Re z_k + ground_share a_ground.
struct RestModes {
  std::size_t count = 0;
  std::array<std::complex<double>, most_modes> rate{}, per_ground{};
  double ground_share = 0.0;
  using Matrix = std::array<std::array<double, 2 * most_modes>, 2 * most_modes>;
  Matrix to{}, from{};  ///< from the modes' states to Re z, Im z, and back
  bool found = true;    ///< not: the states are no such sums, to rounding

  RestModes() = default;
  RestModes(const SceneConstants& constants, std::size_t axis);
  using States = std::array<OscillatorState, most_modes>;
  States vibrations(const States& modes) const { return times(to, modes); }
  States modes(const States& vibrations) const { return times(from, vibrations); }

 private:
  States times(const Matrix& matrix, const States& states) const;
};

/// The roof while the block rests on it from the begin on, for all histories on
/// one building: by axis, at the ground's nodes, with the ground's own
/// factor 1.
struct RestTable {
  /// Empty: rigid. Of several modes, by node, those of `rest`.
  std::array<std::vector<double>, 2> x, y;
  std::array<std::vector<double>, 2> own_a;  ///< empty: rigid
  std::array<const double*, 2> a{};          ///< acceleration; zeros follow
  std::array<std::vector<double>, 2> tile,
      coming;  ///< largest |a|: at the nodes of a tile; of all to come, between nodes too
  std::array<std::vector<double>, 2> spring_tile, spring_coming;  ///< the same of |x|, of one mass
  std::array<std::vector<double>, 2> deviation;  ///< how far it leaves its chord, by tile
  /// By axis, of each state; empty: the roof is known beforehand.
  std::array<std::vector<FreeVibration>, 2> free;
  std::array<RestModes, 2> rest;  ///< of several modes under the block's mass
  std::size_t end = 0;            ///< the last node; of modes some time after the record
  /// Of a roof of modes: by node and axis its acceleration over the sample interval after it, as a
  /// power series of row_terms terms in the elapsed fraction. Empty: another roof.
  std::vector<double> rows;
  std::span<const double, row_terms> row(std::size_t axis, std::size_t node) const {
    return std::span<const double, row_terms>(rows.data() + (2 * node + axis) * row_terms,
                                              row_terms);
  }

  /// @param ground, roof the same each time that a table is made again
  void tabulate(const GroundNodes& ground, const SceneConstants& constants, RoofKind roof);
  void tabulate(const GroundNodes& ground, const std::array<Modes, 2>& modes);
  OscillatorState state(std::size_t axis, std::size_t node, std::size_t k) const {
    const std::size_t i = node * free[axis].size() + k;
    return {x[axis][i], y[axis][i]};
  }
  /// Whether the free vibration of the roof is known.
  bool usable() const { return rest[0].found && rest[1].found; }

 private:
  /// One axis of an oscillator.
  /// @return bound of its |acceleration| after the ground has come to rest
  double tabulate_axis(std::size_t axis, const GroundNodes& ground,
                       const Constants<double>& constants);
  double tabulate_axis(std::size_t axis, const GroundNodes& ground, const Modes& modes);
  double tabulate_modes_at_rest(std::size_t axis, const GroundNodes& ground,
                                const SceneConstants& constants);
};

/// Nodes after the last, of zeros, that a search may read.
constexpr std::size_t padding = 2 * tile_nodes;

inline std::size_t tiles_of(std::size_t last_node) { return last_node / tile_nodes + 1; }
/// Largest |value| by tile; the node at a tile's end counts for it too.
std::vector<double> tile_maxima(const double* values, std::size_t last_node);
/// Largest |value| by tile, between nodes too, of one that leaves its chord by `factor` deviations.
std::vector<double> between_nodes(std::vector<double> at_nodes,
                                  const std::vector<double>& deviation, double factor = 1.0);
/// Of each and all after it, the last followed by `after`.
std::vector<double> suffix_maxima(std::vector<double> values, double after);
/// An interval that ends at a tile's first node counts for it too.
void add_interval_before(std::vector<double>& by_tile);

}  // namespace glissade::block_detail::two_axes
