// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

#include "block/contact/two_axis_contact.hpp"
#include "block/polynomial/power_series.hpp"
#include "block/two_axes/lanes/lane_states.hpp"
#include "block/two_axes/roof/tables.hpp"

namespace glissade::block_detail::two_axes {

/// A history between lanes: where it is, before the begin of which interval's
/// rest.
struct HistoryState {
  LaneMotion<double> motion{};
  ModeMotion<double> modes{};
  SpringMotion<double> springs{};
  std::int64_t node = 0;

  bool any_yields() const { return springs.direction[0] != 0.0 || springs.direction[1] != 0.0; }
  /// The building's state.
  RoofState roof(RoofKind roof) const;
  void set_roof(RoofKind roof, const RoofState& state);
};

/// What acts on the block over the rest of a sample interval, tau in [0, 1] its
/// fraction: power series of the roof's acceleration, as far as the block's own
/// has no part in it, and the vertical.
class RoofPiece {
 public:
  /// The block's velocity in plan by the building's axes, and how much it rises over the piece.
  struct BlockVelocity {
    std::array<double, 2> begin{}, rise{};
  };
  RoofPiece(const HistoryState& state, const GroundNodes& ground, const RestTable& table,
            const SceneConstants& constants, RoofKind roof, const BlockVelocity& block_velocity);

  double length_s() const { return length_s_; }
  Load load(double tau) const;
  /// By how much the friction reserve may be less than on the chord between the piece's ends.
  double deviation() const;
  /// The same on the chord over a part of the piece, over the square of that part's length.
  double bend() const;
  /// Up to a fraction of the piece no |acceleration| of the roof is larger.
  double bound(std::size_t axis, double tau) const;
  /// Raises the largest |acceleration| by axis to that of the roof up to a fraction of the piece.
  void raise(std::array<double, 2>& largest, double tau) const;
  /// The first that a yielding spring does: where, as a fraction of the piece, or never.
  struct SpringEvent {
    double at = never;
    std::size_t axis = 0;
    int direction = 0;  ///< in which it then yields; 0: elastic again
  };
  SpringEvent next_event(const SpringMotion<double>& springs) const;
  /// Takes the ground and the building to a fraction of the piece.
  void move(HistoryState& state, double tau) const;

 private:
  static constexpr int most_terms = 20;
  using Terms = std::array<double, most_terms>;  // Series::c
  static double sum(const Terms& c, int terms, double tau) {
    double total = c[static_cast<std::size_t>(terms) - 1];
    for (int k = terms - 1; k-- > 0;) total = total * tau + c[static_cast<std::size_t>(k)];
    return total;
  }

  void respond(const RoofState& state, const BlockVelocity& block_velocity,
               const SpringMotion<double>& springs);
  void respond_on_modes(const RoofState& state, const BlockVelocity& block_velocity);
  void read(std::span<const double, row_terms> row, double factor, double left, Terms& a) const;

  const SceneConstants* constants_;
  RoofKind roof_;
  double length_s_;
  int terms_ = 2;
  std::array<Terms, 2> a_;
  std::array<std::array<Terms, most_modes>, 2> x_, y_;
  std::array<std::size_t, 2> count_{1, 1};             // of modes
  std::array<std::array<double, 2>, 2> block_rate_{};  // in y, of one mass: at the begin, its rise
  std::array<double, 2> ground_, ground_end_;
  double w_, w_end_;
};

/// Under accelerations of the roof by the building's axes, and the vertical.
inline Load load_of(const Constants<double>& c, const std::array<double, 2>& a, double w) {
  const double fall = c.gravity + w, along = c.c * a[0] + c.s * a[1];
  return {{fall * c.tangent - along, c.s_across * a[0] - c.c_across * a[1]},
          fall + c.tangent * along};
}
/// By how much friction_reserve() may be less, by an acceleration of the roof along an axis.
inline double reserve_per_acceleration(const Constants<double>& c) {
  return std::max(1.0, c.per_aspect) / c.cosine + c.mu_at_rest * c.tangent;
}

/// To the largest |value| of a series up to t.
void raise_largest(double& most, const Series& series, double t);

/// Of a block at rest under a load: how much more friction could hold. Negative where it slides:
/// without a drive it does not, even lifted off.
inline double friction_reserve(const Load& load, const Constants<double>& c) {
  return c.mu_at_rest * std::max(load.normal, 0.0) -
         length({load.drive.s, c.per_aspect * load.drive.y});
}

}  // namespace glissade::block_detail::two_axes
