// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "block/contact/line.hpp"
#include "block/contact/plane_vector.hpp"
#include "glissade/block/two_axis.hpp"

namespace glissade::block_detail {

/// Load of the block, per mass and per cos(slope): the drive, and the normal force. Divided by the
/// cosine, a block at critical friction is exactly on its threshold: tan(slope) = mu.
struct Load {
  Vector drive;
  double normal = 0.0;  ///< negative: uplift
};

/// From the roof acceleration to the load of the block.
class TwoAxisLoading {
 public:
  explicit TwoAxisLoading(const Block& block)
      : g_(block.gravity_mps2),
        tan_(std::tan(std::abs(block.slope_rad))),
        cos_(std::cos(block.slope_rad)),
        cos_azimuth_(std::cos(block.fall_azimuth_rad())),
        sin_azimuth_(std::sin(block.fall_azimuth_rad())) {}

  Load at(double a1, double a2, double w) const {
    const double along = cos_azimuth_ * a1 + sin_azimuth_ * a2;
    const double across = cos_azimuth_ * a2 - sin_azimuth_ * a1;
    return {{(g_ + w) * tan_ - along, -across / cos_}, g_ + w + along * tan_};
  }
  /// Change of `at` with the roof acceleration.
  Load change(double a1, double a2, double w) const {
    const double along = cos_azimuth_ * a1 + sin_azimuth_ * a2;
    const double across = cos_azimuth_ * a2 - sin_azimuth_ * a1;
    return {{w * tan_ - along, -across / cos_}, w + along * tan_};
  }
  double gravity() const { return g_; }
  double tan_slope() const { return tan_; }
  double cos_slope() const { return cos_; }
  double cos_azimuth() const { return cos_azimuth_; }
  double sin_azimuth() const { return sin_azimuth_; }
  /// From slip per cos(slope) to displacement in plan.
  Vector to_plan() const { return {cos_ * cos_, cos_}; }

 private:
  double g_, tan_, cos_, cos_azimuth_, sin_azimuth_;
};

/// The friction f per normal force of a block that slides with v = p - lambda f on an ellipse of
/// friction, by iteration. v_i = p_i sigma / (sigma + lambda mu_i^2) with
/// sigma = |(mu_s v_s, mu_y v_y)|, so sigma is the root of |x| = 1, x_i = mu_i p_i / (sigma +
/// lambda mu_i^2). Newton's method on 1/|x|, which is nearly a line in sigma (Hebden 1973).
class ImplicitEllipse {
 public:
  /// @param sigma to begin with; negative: not known
  explicit ImplicitEllipse(Vector mu, double sigma = -1.0)
      : mu_(mu), squares_(scaled(mu, mu)), sigma_(sigma) {}

  /// For the present sigma, which is then improved; p and lambda may change between calls.
  Vector next(Vector p, double lambda) {
    const Vector forced = scaled(mu_, p), shift = lambda * squares_;
    if (sigma_ < 0.0) {  // To the first order in lambda, friction shortens p as a circle's would.
      const Vector weights = scaled(forced, forced);
      sigma_ = std::max(0.0, length(forced) - dot(weights, shift) / (weights.s + weights.y));
    }
    const Vector inverse{1.0 / (sigma_ + shift.s), 1.0 / (sigma_ + shift.y)};
    const Vector x = scaled(forced, inverse), squares = scaled(x, x);
    const double size2 = squares.s + squares.y;
    size_ = std::sqrt(size2);
    sigma_ = std::max(0.0, sigma_ + (size_ - 1.0) * size2 / dot(squares, inverse));
    return scaled(mu_, x);
  }
  /// |x| of the last call, 1 at the root.
  double size() const { return size_; }
  double sigma() const { return sigma_; }

 private:
  Vector mu_, squares_;
  double sigma_, size_ = 0.0;
};

/// Friction on a circle or an ellipse.
class FrictionEllipse {
 public:
  explicit FrictionEllipse(const EllipticFriction& mu)
      : mu_{mu.along, mu.across}, to_circle_(mu.across == mu.along ? 1.0 : mu.along / mu.across) {}

  bool is_circle() const { return mu_.s == mu_.y; }
  double along() const { return mu_.s; }
  double across() const { return mu_.y; }
  double to_circle() const { return to_circle_; }  ///< a factor on transverse components
  double smallest() const { return std::min(mu_.s, mu_.y); }
  double largest() const { return std::max(mu_.s, mu_.y); }

  /// Positive if the block cannot stick.
  double excess(const Load& load) const {
    const double y = to_circle_ * load.drive.y, n = mu_.s * load.normal;
    return load.drive.s * load.drive.s + y * y - n * n;
  }
  bool may_rest(const Load& load) const { return load.normal >= 0.0 && excess(load) <= 0.0; }

  /// The least deceleration under a load, whatever the direction of the velocity; positive if the
  /// block can stop.
  double least_deceleration(const Load& load) const {
    const double y = to_circle_ * load.drive.y;
    const double left = mu_.s * load.normal - std::sqrt(load.drive.s * load.drive.s + y * y);
    return smallest() / mu_.s * left;
  }

  /// The friction f per normal force of the velocity v = p - lambda f: on the ellipse against v, or
  /// p / lambda if the block then stops.
  Vector implicit_friction(Vector p, double lambda) const {
    if (is_circle()) {
      const double size = length(p);
      if (size > lambda * mu_.s) return (mu_.s / size) * p;
    } else if (lambda > 0.0 && excess({p, lambda}) > 0.0) {
      return on_ellipse(p, lambda);
    }
    return lambda > 0.0 ? (1.0 / lambda) * p : Vector{};
  }

  ImplicitEllipse implicit(double sigma) const { return ImplicitEllipse(mu_, sigma); }

  /// Of a block that slides with v, not zero.
  Vector sliding(Vector v) const {
    const Vector scaled_v = scaled(v, mu_);
    const double size = length(scaled_v);
    return size > 0.0 ? (1.0 / size) * scaled(scaled_v, mu_) : Vector{};
  }

 private:
  Vector on_ellipse(Vector p, double lambda) const {
    ImplicitEllipse friction(mu_);
    Vector f;
    for (int iteration = 0; iteration < 60; ++iteration) {
      f = friction.next(p, lambda);
      if (std::abs(friction.size() - 1.0) <= 4.0 * std::numeric_limits<double>::epsilon()) break;
    }
    return f;
  }

  Vector mu_;
  double to_circle_;
};

}  // namespace glissade::block_detail
