// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "glissade/block/slide.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/finite.hpp"

namespace glissade::block_detail {

/// Roof acceleration at an instant: a horizontal, w vertical.
struct Roof {
  double a = 0.0, w = 0.0;
};

/// Acceleration of the block along the slope if it slid down, or up, each positive in its own
/// direction (theory.md, 1.2). The block at rest starts to slide if one of them is positive; a
/// sliding block accelerates while the drive of its direction is positive. Both are linear in
/// (a, w), hence linear in time inside a sample interval.
struct Drive {
  double down = 0.0, up = 0.0;
};

/// Coefficients of a quantity that is linear in the roof's acceleration, m/s2.
struct DriveLine {
  double a = 0.0, w = 0.0, constant = 0.0;
  double at(Roof r) const { return a * r.a + w * r.w + constant; }
};

/// tan(slope) - mu, which decides on free sliding (theory.md, 1.5): exactly zero at critical
/// friction, where both agree to 1e-12. Friction that exceeds the slope by rounding alone stops
/// nothing within the length of any record. All models take this rule.
inline double beyond_friction(double tan_slope, double friction) {
  constexpr double agree = 1e-12;
  const double surplus = tan_slope - friction;
  return std::abs(surplus) <= agree * friction ? 0.0 : surplus;
}

/// A surface that falls toward -x is the mirror image of one that falls toward +x: all equations
/// are those of |slope| under `mirror` times the horizontal motion.
inline double mirror(const Block& block) { return block.slope_rad < 0.0 ? -1.0 : 1.0; }

/// @throw std::invalid_argument if a number is not finite
inline void require_block(const Block& block) {
  require_finite(
      {block.friction.along, block.slope_rad, block.gravity_mps2, block.law.static_over_sliding},
      "friction, slope, gravity");
  GLISSADE_EXPECTS(block.friction.along >= 0.0 && std::abs(block.slope_rad) < std::numbers::pi / 2);
}

/// The equations of motion of a block on its |slope|.
class Contact {
 public:
  explicit Contact(const Block& block)
      : g_(block.gravity_mps2),
        tan_(std::tan(std::abs(block.slope_rad))),
        sin_(std::sin(std::abs(block.slope_rad))),
        cos_(std::cos(block.slope_rad)),
        gravity_down_(cos_ * beyond_friction(tan_, block.friction.along)),
        gravity_up_(-cos_ * (tan_ + block.friction.along)),
        inertia_down_(cos_ + block.friction.along * sin_),
        inertia_up_(cos_ - block.friction.along * sin_) {}

  /// sin - mu cos and cos + mu sin are the friction-corrected parts of gravity and of the roof's
  /// inertia.
  Drive sliding(Roof r) const {
    return {(g_ + r.w) * gravity_down_ - r.a * inertia_down_,
            (g_ + r.w) * gravity_up_ + r.a * inertia_up_};
  }
  DriveLine down() const { return {-inertia_down_, gravity_down_, g_ * gravity_down_}; }
  DriveLine up() const { return {inertia_up_, gravity_up_, g_ * gravity_up_}; }
  /// Minus the normal force: positive in uplift, as the drives are in sliding.
  DriveLine lift() const { return {-sin_, -cos_, -g_ * cos_}; }
  /// Without contact there is no friction.
  Drive frictionless(Roof r) const {
    const double along_slope = (g_ + r.w) * sin_ - r.a * cos_;
    return {along_slope, -along_slope};
  }
  double normal(Roof r) const { return (g_ + r.w) * cos_ + r.a * sin_; }  ///< N/m; negative: uplift
  double gravity() const { return g_; }
  double cos_slope() const { return cos_; }
  double sin_slope() const { return sin_; }
  /// Infinite on a flat roof.
  double cot_slope() const {
    return sin_ > 0.0 ? cos_ / sin_ : std::numeric_limits<double>::infinity();
  }
  bool slides_at_rest() const { return gravity_down_ > 0.0; }
  bool stops_at_rest() const { return gravity_down_ < 0.0; }

 private:
  double g_, tan_, sin_, cos_, gravity_down_, gravity_up_, inertia_down_, inertia_up_;
};

}  // namespace glissade::block_detail
