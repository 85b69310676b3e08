// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>

#include "glissade/block/slide.hpp"

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
  const double surplus = tan_slope - friction;
  return std::abs(surplus) <= 1e-12 * friction ? 0.0 : surplus;
}

/// The equations of motion of a block on a slope >= 0.
class Contact {
 public:
  Contact(const Block& block, double slope)
      : g_(block.gravity_mps2),
        sin_(std::sin(slope)),
        cos_(std::cos(slope)),
        gravity_down_(cos_ * beyond_friction(std::tan(slope), block.friction)),
        gravity_up_(-cos_ * (std::tan(slope) + block.friction)),
        inertia_down_(cos_ + block.friction * sin_),
        inertia_up_(cos_ - block.friction * sin_) {}

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
  double cos_slope() const { return cos_; }
  bool slides_at_rest() const { return gravity_down_ > 0.0; }
  bool stops_at_rest() const { return gravity_down_ < 0.0; }

 private:
  double g_, sin_, cos_, gravity_down_, gravity_up_, inertia_down_, inertia_up_;
};

/// The number of samples up to the last non-zero one, at least one: padding changes no bit.
inline std::size_t without_trailing_zeros(const RoofAcceleration& roof) {
  std::size_t n = roof.horizontal_mps2.size();
  while (n > 1 && roof.horizontal_mps2[n - 1] == 0.0 &&
         (roof.vertical_mps2.empty() || roof.vertical_mps2[n - 1] == 0.0)) {
    --n;
  }
  return n;
}

}  // namespace glissade::block_detail
