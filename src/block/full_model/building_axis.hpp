// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "block/polynomial/power_series.hpp"
#include "glissade/building/modes.hpp"
#include "glissade/building/roof_motion.hpp"
#include "glissade/building/yielding.hpp"
#include "glissade/core/oscillator.hpp"

namespace glissade::block_detail {

/// The modes of an axis that a record of this step can excite, without those that are is_rigid();
/// rigid if none is left. Beside one mass, modes without participation have no mass and are left
/// out too.
Modes responding(const Modes& modes, double dt_s);

/// Effect of the block on a mode of the building since the start of a step.
struct Added {
  double x = 0.0, y = 0.0;
};

/// A quantity linear over a piece of time.
struct Ramp {
  double begin = 0.0, end = 0.0;
  double at(double fraction) const { return begin + fraction * (end - begin); }
};

/// An axis of the building over a piece of time, tau in [0, 1] the elapsed fraction.
struct AxisSeries {
  Series x[most_modes], y[most_modes];  ///< scaled states of the modes (core/oscillator.hpp)
  Series resisting;                     ///< E, see BuildingAxis
  double resisting_bound = 0.0;         ///< no |E| is larger
  // Of several modes; of one mass they are E and its x:
  Series shear;   ///< force on the base, over the building's mass
  Series roof_x;  ///< of the roof relative to the ground, scaled as the first mode's x
  double shear_bound = 0.0, x_bound = 0.0;
};

/// An axis over a whole piece with the block at rest on it: what it has at the end, linear in the
/// states (x, y) of its modes and in the ground at both ends, in this order.
struct RestMap {
  static constexpr std::size_t most = 2 * most_modes + 2;
  using Row = std::array<double, most>;
  std::size_t states = 0;                  ///< 2 of each mode; then the ground
  std::array<Row, 2 * most_modes> next{};  ///< states
  Row e_begin{}, e_end{};                  ///< E
  Row e_deviation{}, shear{}, roof_x{};    ///< bounds: of E from its chord; of |AxisSeries|

  double value(const Row& row, const Row& of) const {
    double sum = 0.0;
    for (std::size_t j = 0; j < states + 2; ++j) sum += row[j] * of[j];
    return sum;
  }
  double bound(const Row& row, const Row& of) const {
    double sum = 0.0;
    for (std::size_t j = 0; j < states + 2; ++j) sum += row[j] * std::abs(of[j]);
    return sum;
  }
};

/// A mode of an axis (building/modes.hpp), with its scaled state.
struct AxisMode {
  double omega_radps = 0.0, twice_zeta = 0.0;
  double participation = 1.0, mass_share = 1.0;
  double kappa = 1.0;       ///< its part of the interaction, gamma / (e sum of gamma^2 / e)
  double roof_per_x = 1.0;  ///< gamma over omega^2, times omega^2 of the first mode
  double x = 0.0, y = 0.0;

  /// How the mode's acceleration, by which the interaction reduces that of the roof, adds to it.
  double gain() const { return participation * kappa; }
};

/// One axis of the building: mass a = E - interaction, in accelerations, with E that of the roof
/// without the array. Each mode has x = omega^2 D, y = omega D', E_n = -(2 zeta y + x), and
///   E = (1 - sum of gamma) a_ground + sum of gamma E_n
///   x' = omega y,   y' = omega (E_n - kappa (E - a) - a_ground)
/// One mass, gamma = kappa = 1, may yield: E = -(2 zeta y + s), s the spring's force per mass of
/// the building. A yielding spring is s = hardening x + (1 - hardening) z, where z is x limited to
/// the yield force (decomposition of the bilinear spring by Bouc): z follows x, or is constant at
/// +- the yield force (yielding).
class BuildingAxis {
 public:
  BuildingAxis(const Modes& modes, const Yielding& yielding, double mass_ratio, double piece_s);

  bool rigid() const { return size_ == 0; }
  /// Or rigid: E is the base shear too.
  bool one_mass() const { return one_mass_; }
  std::span<const AxisMode> modes() const { return {modes_.data(), size_}; }
  bool yields() const { return yields_; }
  /// m/M times the sum of gamma^2 / e: the reduction of a by the array's force over its mass.
  double accelerance() const { return accelerance_; }
  /// 1 + accelerance() with the array at rest on the roof; a rigid axis carries it too.
  double stuck_mass() const { return stuck_mass_; }
  double resisting(double ground) const;
  /// The interaction in the base shear, over that in a: (1 - sum of gamma) / sum of gamma^2 / e.
  double shear_per_interaction() const { return shear_per_interaction_; }
  double stiffness() const {
    return yield_direction_ == 0 ? 1.0 : hardening_;
  }  ///< tangent, over that of the elastic spring

  // Of one mass:
  double omega_radps() const { return modes_[0].omega_radps; }
  double twice_zeta() const { return modes_[0].twice_zeta; }
  double x() const { return modes_[0].x; }
  double y() const { return modes_[0].y; }
  double spring() const { return hardening_ * x() + (1.0 - hardening_) * z_; }
  /// Distance of z from its limits, in either direction.
  double yield_left() const { return yields_ ? yield_ - std::abs(z_) : never; }

  /// Over a piece with linear ground and interaction, with the spring in its present state.
  AxisSeries motion(double length_s, const Ramp& ground, double mass,
                    const Ramp& interaction = {}) const;

  /// Time at which the spring first yields or unloads, or never.
  double next_yield(const AxisSeries& motion) const;
  /// The state at a fraction of the piece, with the additions since then, by mode.
  void follow(const AxisSeries& motion, double fraction, const Added* added = nullptr);
  /// Applies the event that next_yield() found.
  void yield();

  /// Sets spring force and state of one mass after whole pieces of rest (RestingAxis).
  void rest_to(double spring_force, double y) {
    const double change = spring_force - spring();
    modes_[0].x = yields_ ? x() + change : spring_force;
    if (yields_) z_ += change;
    modes_[0].y = y;
  }
  bool yielding() const { return yield_direction_ != 0; }

  RestMap rest_map(double piece_s) const;
  /// What a RestMap is linear in.
  RestMap::Row rest_row(const Ramp& ground) const;
  /// To the end of a whole piece at rest.
  void rest_on(const RestMap& map, const RestMap::Row& row);

  /// |a| never exceeds this again while the block rests and the ground is at rest.
  double largest_to_come_mps2() const;

  /// A piece at rest, of one mass, in the spring force s and y, while the spring does not yield.
  const OscillatorStep& rest_step() const { return rest_; }
  double phase() const { return phase_; }

 private:
  template <bool kOneMass>
  void expand(AxisSeries& m, double length_s, const double (&ground)[2], double mass,
              const double (&interaction)[2]) const;
  double largest_by_energy_mps2() const;

  std::array<AxisMode, most_modes> modes_;
  std::size_t size_ = 0;
  bool one_mass_ = true;
  double ground_share_ = 1.0, mass_left_out_ = 1.0, accelerance_ = 0.0;
  double shear_per_interaction_ = 0.0, mass_ratio_;
  int terms_ = 2;
  bool yields_ = false;
  double hardening_ = 1.0, yield_ = 0.0;  // hardening ratio; yield force
  double stuck_mass_ = 1.0, phase_ = 0.0;
  OscillatorStep rest_;

  double z_ = 0.0;
  int yield_direction_ = 0;  // +1, -1: direction of yielding
};

}  // namespace glissade::block_detail
