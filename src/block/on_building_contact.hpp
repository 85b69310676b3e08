// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "two_axis_contact.hpp"

namespace glissade::block_detail {

/// By the building's two axes.
using Axes = std::array<double, 2>;

/// How far the roof gives way to the block: R, by which the roof's acceleration changes when the
/// block pulls at it, in the axes of the slope and per cos(slope) as Load is.
struct Mobility {
  Axes axis{};  ///< by the building's axes: m/M of an axis that can move, 0 of a rigid one
  double ss = 0.0, sy = 0.0, yy = 0.0;
  double mean = 0.0;
  double coupling = 0.0;  ///< at least what an iterate leaves of the error before it
  bool isotropic = true;  ///< and the normal force does not depend on it

  bool none() const { return axis[0] == 0.0 && axis[1] == 0.0; }
  Vector operator*(Vector x) const { return {ss * x.s + sy * x.y, sy * x.s + yy * x.y}; }
};

/// Block and roof at an instant, or over an implicit stage. All per cos(slope), as Load.
struct ContactState {
  Vector v;             ///< of the block
  Vector a;             ///< its rate
  Vector friction;      ///< f, per normal force
  double normal = 0.0;  ///< negative: uplift
  Axes push{};          ///< what the block takes off the roof's acceleration, m/s2
};

/// The equations of block and roof in contact. With t = (tan(slope), 0), the load (d, n) the block
/// would have on a roof of acceleration e that does not feel it, and f the friction per normal
/// force N:
///   N = n / (1 + t.R(t - f)),   v' = d + N (R (t - f) - f)
/// They have one solution where the divisor is positive for every f.
class BuildingContact {
 public:
  explicit BuildingContact(const TwoAxisBlock& block);

  const TwoAxisLoading& loading() const { return loading_; }
  const FrictionEllipse& friction() const { return friction_; }
  const FrictionEllipse& friction_at_rest() const { return at_rest_; }
  const FrictionLaw& law() const { return law_; }

  Mobility mobility(const Axes& by_axis) const;
  bool is_regular(const Mobility& mobility) const;
  /// |v'| is at most |d| + strongest() n.
  double strongest(const Mobility& mobility) const;

  /// mu(|v|) / mu.
  double factor(Vector v) const { return factor(length(v)); }

  double factor(double speed_per_cos) const {
    return law_.depends_on_speed() ? factor_at(loading_.cos_slope() * speed_per_cos) : 1.0;
  }
  /// The least of mu(|v|) / mu that a block of this velocity meets on its way to rest.
  double least_factor(Vector v) const { return std::min(1.0, factor(v)); }
  /// Friction that falls with speed must fall slower than an implicit step lets the speed fall.
  double longest_step_s(const Load& load, const Mobility& mobility) const {
    const double falls = law_.depends_on_speed() ? (1.0 - law_.fast_ratio) * law_.rate_spm : 0.0;
    if (!(falls > 0.0)) return never;
    const double rate = strongest(mobility) * std::max(load.normal, 0.0) * falls;
    return rate > 0.0 ? 2.0 / (rate * loading_.cos_slope()) : never;
  }

  /// The block that slides with v = known + own v'.
  /// @param e, w the roof's acceleration if it did not feel the block, and the vertical's
  /// @param guess of the friction
  /// @param enough velocity by which v may be off
  ContactState slide(Vector known, double own, const Axes& e, double w, const Mobility& mobility,
                     Vector guess, double enough) const;

  /// The same on a roof that does not feel the block.
  ContactState slide_unfelt(Vector known, double own, const Load& load) const {
    ContactState c;
    c.normal = load.normal;
    const double normal = std::max(load.normal, 0.0);
    if (normal > 0.0) c.friction = holding(known + own * load.drive, own * normal);
    c.a = load.drive - normal * c.friction;
    c.v = known + own * c.a;
    return c;
  }

  /// The acceleration with which a block at rest begins to slide.
  Vector release_acceleration(const Axes& e, double w, const Mobility& mobility) const;

  /// Of given friction, which a block that lifts does not have.
  ContactState with_friction(Vector friction, const Axes& e, double w,
                             const Mobility& mobility) const;

  /// Of given v', 0 where the block rests: the roof's acceleration, and the load that friction
  /// must hold.
  struct Held {
    Axes a;
    Load load;
  };
  Held held(Vector acceleration, const Axes& e, double w, const Mobility& mobility) const;

  /// From an acceleration per cos(slope) to the building's axes.
  Axes to_building(Vector a) const {
    const double c = loading_.cos_slope(), along = c * c * a.s, across = c * a.y;
    return {loading_.cos_azimuth() * along - loading_.sin_azimuth() * across,
            loading_.sin_azimuth() * along + loading_.cos_azimuth() * across};
  }

 private:
  double factor_at(double speed_mps) const {
    return law_.fast_ratio - (law_.fast_ratio - 1.0) * std::exp(-law_.rate_spm * speed_mps);
  }
  /// Friction per normal force of v = p - lambda f(v); rest where that can be.
  Vector holding(Vector p, double lambda) const {
    return law_.depends_on_speed() ? holding_by_speed(p, lambda) : friction_.holding(p, lambda);
  }
  Vector holding_by_speed(Vector p, double lambda) const;
  Vector iterate(Vector known, double own, const Load& bare, const Mobility& mobility, Vector guess,
                 double enough, const Axes& e, double w) const;

  TwoAxisLoading loading_;
  FrictionEllipse friction_, at_rest_;
  FrictionLaw law_;
};

}  // namespace glissade::block_detail
