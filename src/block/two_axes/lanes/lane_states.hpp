// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "glissade/building/modes.hpp"

namespace glissade::block_detail::two_axes {

/// What the block lies on: ground; a building, of one mass or of several modes, without the mass of
/// the block; both with it; one mass that yields, with it or without.
enum class RoofKind { rigid, building, modes, coupled, coupled_modes, yielding };

/// Whether the block moves it, in the equations at least.
constexpr bool has_mass(RoofKind roof) {
  return roof == RoofKind::coupled || roof == RoofKind::coupled_modes || roof == RoofKind::yielding;
}
constexpr bool is_one_mass_with_block(RoofKind roof) {
  return roof == RoofKind::coupled || roof == RoofKind::yielding;
}
/// Whether the building's state goes with the block: else the roof is known beforehand.
constexpr bool has_state(RoofKind roof) { return roof == RoofKind::building || has_mass(roof); }

/// Whether friction depends on the block's speed.
enum class Friction { coulomb, by_speed };

/// Terms of the power series of a roof of modes over a sample interval (RestTable::rows).
constexpr std::size_t row_terms = 10;

/// A block that slides, at an instant. Velocity per cos(slope), displacement in
/// plan, both in the axes of the slope. A building by its own axes, scaled
/// (core/oscillator.hpp): x, and Y = y + omega rho b with b the block's
/// velocity in plan and rho = r / (1 + r), which leaves no rate of b in the
/// equations.
template <class Number>
struct LaneMotion {
  Number left;    ///< fraction of the sample interval that is still to come, (0, 1]
  Number trial;   ///< the same, to try in an implicit step; infinite: not known, 0: it diverges
  Number forced;  ///< 1: the next implicit step is made before any stop, else 0
  Number v_s, v_y;
  Number at_s, at_y;
  Number ground_1, ground_2, w;  ///< mps2, now
  Number x_1, y_1, x_2, y_2;
  Number fastest, path;  ///< so far: |v|, and its integral
  Number farthest2;      ///< so far: displacement squared
  Number ahead_s, back_s, ahead_y,
      back_y;  ///< so far: by axis and direction, >= 0
};

/// What does not change in a history.
template <class Number>
struct Constants {
  Number factor_1, factor_2, factor_w;
  Number gravity, mu, tangent, cosine,
      cosine2;  ///< of the slope; cosine2 its square
  Number mu_at_rest;
  Number fast_excess, speed_rate;  ///< FrictionLaw: fast over slow, less 1; per LaneMotion's speed
  Number c, s;                     ///< cosine and sine of the azimuth
  Number c_across, s_across;       ///< the same over the slope's cosine
  Number tolerance;
  Number no_speed;            ///< counts as none, over the largest so far
  Number aspect, per_aspect;  ///< of the friction: across over along, and its inverse
  Number omega_1, omega_2, twice_zeta_1, twice_zeta_2,
      per_mass;  ///< per_mass = 1 / (1 + r)
  Number omega_rho_1, omega_rho_2;
  Number kappa, rho_sin_cos,
      per_kappa_y;    ///< 1 - rho cos^2, rho sin cos, 1 / (1 - rho)
  Number anisotropy;  ///< how much the block's rate differs by direction, over mu N
};

/// A building of several modes under the block's mass (theory.md, 3.4), by axis and mode; zero
/// where there is no mode. With gamma and kappa of a mode, and rho = r / (1 + r) of its axis:
///   x and Y = y + omega kappa rho b, scaled, times gamma.
template <class Number>
struct ModeMotion {
  Number x[2][most_modes], y[2][most_modes];
};

/// What does not change in a history on such a building.
template <class Number>
struct ModeConstants {
  Number omega[2][most_modes], twice_zeta[2][most_modes];
  Number gamma[2][most_modes];
  Number share[2][most_modes], omega_share[2][most_modes];  ///< share = gamma kappa rho
  Number ground_share[2], per_mass[2];                      ///< per_mass = 1 - rho
  Number longest_s;  ///< over which the lanes' series of all modes converge
  /// With d the block's rate and p its load on a roof that it does not accelerate, A d = p -
  /// friction: A = (Constants::kappa, kappa_sy; kappa_sy, kappa_y), and the normal force is less by
  /// (Constants::rho_sin_cos, rho_sin) . d.
  Number kappa_sy, kappa_y, rho_sin;
  Number lift_s, lift_y;  ///< (rho_sin_cos, rho_sin) A^-1
  /// In the axes in which M^-1 A M^-1 is diagonal, turned from those of M v: its numbers, and what
  /// the normal force is less by.
  Number turn_c, turn_s, principal_1, principal_2, lifts_1, lifts_2;
  Number feedback_damping, feedback_spring;  ///< ImplicitSeries::FeedBack
};

/// The springs of a building that yields (theory.md, 2.3), by axis. The spring's force, scaled as
/// LaneMotion::x, takes its place: elastic between two limits, it yields beyond them.
template <class Number>
struct SpringMotion {
  Number low[2], high[2];
  Number direction[2];  ///< of yielding, +1 or -1; 0: elastic
};

/// What does not change of them.
template <class Number>
struct SpringConstants {
  Number hardening[2];
  Number range[2];   ///< between the limits; infinite where the axis does not yield
  Number margin[2];  ///< far below the tolerance: how far beyond a limit it yields, so that a step
                     ///< from there does not begin with an event
};

/// What does not change in a history, with `modes` on a roof of coupled_modes.
struct SceneConstants : Constants<double> {
  std::size_t count[2] = {};  ///< of modes
  ModeConstants<double> modes{};
  SpringConstants<double> springs{};
};

/// Histories that slide, side by side.
struct LaneStates {
  static constexpr std::size_t count = 32;
  using Lanes = double[count];

  alignas(64) LaneMotion<Lanes> motion = {};
  alignas(64) Constants<Lanes> constants = {};
  std::size_t modes = 0;  ///< of an axis, at most; else there is no ModeMotion
  alignas(64) ModeMotion<Lanes> mode_motion = {};
  alignas(64) ModeConstants<Lanes> mode_constants = {};
  alignas(64) SpringMotion<Lanes> spring_motion = {};  ///< of RoofKind::yielding, as the constants
  alignas(64) SpringConstants<Lanes> spring_constants = {};
  alignas(64) std::int64_t node[count] = {};   ///< before which sample interval's begin
  alignas(64) std::int64_t limit[count] = {};  ///< node from which on the lane does not go
  alignas(64) std::int64_t rows[count] = {};   ///< RestTable::rows, from GroundRows::nodes on
  std::uint64_t active = 0;                    ///< lanes, as bits
  alignas(64) double next2[count] = {};        ///< DistanceCrossings::next2
  /// Of a lane's last step that reached it: displacement in plan as a series in the fraction of the
  /// interval's rest of `length_s`, up to `fraction`.
  static constexpr std::size_t path_terms = 8;
  struct Passed {
    double path_s[path_terms][count], path_y[path_terms][count];
    double begin_s[count], length_s[count], fraction[count];
  };
  alignas(64) Passed passed = {};
  bool follows_shear = false;  ///< of any lane; else there is no Shear
  /// For the base shear, by axis: the largest |acceleration| that the building alone gave the roof,
  /// infinite where nobody asks; of a lane's last step that might exceed it a series in the
  /// fraction of the interval's rest, up to `fraction`.
  struct Shear {
    double largest[2][count], a[2][row_terms][count], fraction[count];
  };
  alignas(64) Shear shear = {};

  template <template <class> class Fields>
  static void store(Fields<Lanes>& rows, std::size_t lane, const Fields<double>& column) {
    for (std::size_t k = 0; k < sizeof(column) / sizeof(double); ++k)
      std::memcpy(reinterpret_cast<char*>(&rows) + (k * count + lane) * sizeof(double),
                  reinterpret_cast<const char*>(&column) + k * sizeof(double), sizeof(double));
  }
  template <template <class> class Fields>
  static void load(const Fields<Lanes>& rows, std::size_t lane, Fields<double>& column) {
    for (std::size_t k = 0; k < sizeof(column) / sizeof(double); ++k)
      std::memcpy(reinterpret_cast<char*>(&column) + k * sizeof(double),
                  reinterpret_cast<const char*>(&rows) + (k * count + lane) * sizeof(double),
                  sizeof(double));
  }
};

/// Ground at the nodes, four numbers each: both axes, the vertical, nothing.
/// The last is zero.
struct GroundRows {
  const double* nodes;
  std::int64_t last;
  double dt_s;
  bool vertical;  ///< whether there is one
};

/// n dt / |v| above which steps are implicit, and below which they are explicit again.
constexpr double stiff = 150.0, smooth = 100.0;
/// The least normal force of an explicit step, as a fraction of the weight. Below it, and while the
/// block is lifted off, steps are implicit, until it is a little larger.
constexpr double least_weight = 0.05, enough_weight = 0.06;

/// The least projection of the velocity after an explicit step on that before, over its square: the
/// direction turns by less than a quarter circle, and no peak is passed unseen.
constexpr double least_alignment = 0.2;

enum class StepKind {
  taylor,    ///< explicit
  implicit,  ///< where a Taylor series would have to be short: at low speed, and around uplift
};

/// Lanes as bits.
struct Stepped {
  std::uint64_t event = 0;   ///< for LaneHistory::event
  std::uint64_t other = 0;   ///< to go on by the other kind of step
  std::uint64_t passed = 0;  ///< reached LaneStates::next2
  std::uint64_t lifted = 0;  ///< without normal force
  std::uint64_t shear = 0;   ///< might exceed LaneStates::Shear::largest
};

/// One step of every active lane.
Stepped step(LaneStates& lanes, const GroundRows& ground, RoofKind roof, Friction friction,
             StepKind kind);
/// The same on a roof that the block accelerates, compiled by itself.
Stepped coupled_step(LaneStates& lanes, const GroundRows& ground, RoofKind roof, StepKind kind);
/// The same with friction that depends on speed.
Stepped by_speed_step(LaneStates& lanes, const GroundRows& ground, RoofKind roof, StepKind kind);
/// The same on one that yields.
Stepped yielding_step(LaneStates& lanes, const GroundRows& ground, Friction friction,
                      StepKind kind);

}  // namespace glissade::block_detail::two_axes
