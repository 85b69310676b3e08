// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "block/contact/contact.hpp"
#include "block/events/coupled_spring.hpp"
#include "block/polynomial/power_series.hpp"
#include "glissade/block/coupled.hpp"
#include "glissade/core/not_converged.hpp"

namespace glissade::block_detail {

/// Fourteen terms and more fall below rounding on a piece of this phase.
constexpr double longest_phase = 0.4;  // 1/16 period

/// Effect of the block on the roof: mass a = E - weight (g + w), with E the spring and damping
/// force per mass of the building, opposite to its displacement.
struct ContactRegime {
  double mass = 1.0, weight = 0.0;
  DriveLine drive;  ///< while sliding: the block's, in its own direction
};

/// The contact equations of a coupled roof (theory.md, 2.2).
class CoupledContact : public Contact {
 public:
  CoupledContact(const Block& block, double mass_ratio)
      : Contact(block), at_rest_(with_static_friction(block)), mass_ratio_(mass_ratio) {}

  /// With static friction: the block starts to slide where one of its drives is positive.
  const Contact& at_rest() const { return at_rest_; }

  ContactRegime stuck() const { return {1.0 + mass_ratio_, 0.0, {}}; }
  ContactRegime sliding_down() const { return sliding_regime(down(), down().w); }
  ContactRegime sliding_up() const { return sliding_regime(up(), -up().w); }
  ContactRegime lifted(int direction) const {
    return sliding_regime(frictionless(direction), sin_slope());
  }
  /// Without friction, in the direction of sliding.
  DriveLine frictionless(int direction) const {
    return {-direction * cos_slope(), direction * sin_slope(), direction * sin_slope() * gravity()};
  }
  double mass_ratio() const { return mass_ratio_; }

 private:
  static Block with_static_friction(Block block) {
    block.friction.along *= block.law.static_over_sliding;
    return block;
  }
  /// @param q sin - sigma mu cos: the contact force pushes the roof by -m q N'/cos per N'
  ContactRegime sliding_regime(const DriveLine& drive, double q) const {
    return {1.0 + mass_ratio_ * sin_slope() * q, mass_ratio_ * cos_slope() * q, drive};
  }
  Contact at_rest_;
  double mass_ratio_;
};

/// The oscillator of the building without the array.
struct BuildingOscillator {
  double omega_radps = 0.0, damping_ratio = 0.0;  ///< omega 0: rigid
  int terms = 0;                                  ///< of a series on a piece
  bool rigid() const { return omega_radps == 0.0; }
};

/// Into how many pieces, of longest_phase at most, an interval of this phase is divided: a power of
/// two.
inline double pieces_of(double phase) {
  return std::exp2(std::max(0.0, std::ceil(std::log2(phase / longest_phase))));
}

/// The oscillator, and into how many pieces of equal length a sample interval is divided for it.
struct Subdivision {
  BuildingOscillator building;
  int pieces = 1;
};
Subdivision subdivide(const Oscillator& oscillator, const CoupledContact& contact, double dt_s);

/// Limit of the ring-down in sample intervals, reached by undamped buildings.
/// @throw NotConverged if the step is so short that it would take minutes
inline std::size_t longest_ring_down(double dt_s) {
  const double intervals = std::ceil(RoofMotionOptions{}.longest_ring_down_s / dt_s);
  if (intervals > 0x1p24)  // some 10 s
    throw NotConverged(
        "a ring-down may take more than 16,777,216 steps of the record: give it a longer step");
  return static_cast<std::size_t>(intervals);
}

/// The ground over a piece of time or over the rest of it: linear.
struct GroundPiece {
  double length_s = 0.0;
  Roof begin, end;
  void keep_after(double tau) {
    begin.a += (end.a - begin.a) * tau;
    begin.w += (end.w - begin.w) * tau;
    length_s *= 1.0 - tau;
  }
};

/// Scaled state of the building alone (core/oscillator.hpp): x = omega^2 u, y = omega u'.
struct RoofState {
  double x = 0.0, y = 0.0;
};

/// The building over a piece, in one regime of contact.
struct RoofMotionSeries {
  Series x, y;       ///< scaled state
  Series resisting;  ///< E = -(f + 2 zeta y), f = x where the spring has not yielded
  Series a;          ///< absolute acceleration
  double w_begin, w_rise;

  /// Bound of the change of a from its value at the start.
  double largest_change() const {
    double sum = 0.0;
    for (int k = 1; k < a.terms; ++k) sum += std::abs(a.c[k]);
    return sum;
  }
  /// From largest_change() alone, without the series.
  bool is_negative(const DriveLine& line, double a_change) const {
    return line.at({a.c[0], w_begin}) + std::abs(line.a) * a_change +
               std::max(line.w * w_rise, 0.0) <
           0.0;
  }
  /// A quantity that is linear in (a, w).
  Series line(const DriveLine& of) const {
    Series s;
    s.terms = a.terms;
    for (int k = 0; k < a.terms; ++k) s.c[k] = of.a * a.c[k];
    s.c[0] += of.w * w_begin + of.constant;
    s.c[1] += of.w * w_rise;
    return s;
  }
};

RoofMotionSeries roof_motion_series(const BuildingOscillator& building, const ContactRegime& regime,
                                    double gravity_mps2, const RoofState& from,
                                    const SpringLine& spring, const GroundPiece& ground);

}  // namespace glissade::block_detail
