// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "block/contact/two_axis_contact.hpp"

namespace glissade::block_detail {

/// By the two axes of the building.
using Axes = std::array<double, 2>;

/// Compliance R of the roof: change of the roof acceleration per force of the block, in the axes of
/// the slope and per cos(slope) as Load is.
struct Accelerance {
  Axes axis{};  ///< by the axes of the building: m/M of an axis that can move, 0 of a rigid one
  double ss = 0.0, sy = 0.0, yy = 0.0;
  double mean = 0.0;
  double coupling = 0.0;  ///< bound of the error of an iterate over the one before
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
  Axes interaction{};   ///< reduction of the roof acceleration by the block, m/s2
};

/// The equations of block and roof in contact. With t = (tan(slope), 0), the load (d, n) of the
/// block on an uncoupled roof of acceleration e, and f the friction per normal force N:
///   N = n / (1 + t.R(t - f)),   v' = d + N (R (t - f) - f)
/// They have one solution if the divisor is positive for every f.
class BuildingContact {
 public:
  explicit BuildingContact(const Block& block);

  const TwoAxisLoading& loading() const { return loading_; }
  const FrictionEllipse& friction() const { return friction_; }
  const FrictionEllipse& friction_at_rest() const { return at_rest_; }
  const FrictionLaw& law() const { return law_; }

  Accelerance accelerance(const Axes& by_axis) const;
  bool is_regular(const Accelerance& accelerance) const;
  /// |v'| is at most |d| + friction_bound() n.
  double friction_bound(const Accelerance& accelerance) const;

  /// mu(|v|) / mu.
  double factor(Vector v) const { return factor(length(v)); }

  double factor(double speed_per_cos) const {
    return law_.depends_on_speed() ? law_.factor(loading_.cos_slope() * speed_per_cos) : 1.0;
  }
  /// The least of mu(|v|) / mu between this velocity and rest.
  double least_factor(Vector v) const { return std::min(1.0, factor(v)); }
  /// Friction that decreases with speed must do so slowly permitted_error for an implicit step to
  /// have one solution.
  double longest_step_s(const Load& load, const Accelerance& accelerance) const {
    const double falls = law_.depends_on_speed() ? law_.steepest_fall() : 0.0;
    if (!(falls > 0.0)) return never;
    const double rate = friction_bound(accelerance) * std::max(load.normal, 0.0) * falls;
    return rate > 0.0 ? 2.0 / (rate * loading_.cos_slope()) : never;
  }

  /// The block that slides with v = known + gamma_h v', an implicit stage of gamma_h = gamma times
  /// the step.
  /// @param e, w the acceleration of the uncoupled roof, and the vertical one
  /// @param guess initial value of the friction
  /// @param permitted_error permitted error of v
  ContactState slide(Vector known, double gamma_h, const Axes& e, double w,
                     const Accelerance& accelerance, Vector guess, double permitted_error) const;

  /// The same on an uncoupled roof.
  ContactState slide_uncoupled(Vector known, double gamma_h, const Load& load) const {
    ContactState c;
    c.normal = load.normal;
    const double normal = std::max(load.normal, 0.0);
    if (normal > 0.0)
      c.friction = implicit_friction(known + gamma_h * load.drive, gamma_h * normal);
    c.a = load.drive - normal * c.friction;
    c.v = known + gamma_h * c.a;
    return c;
  }

  /// The acceleration with which a block at rest begins to slide.
  Vector release_acceleration(const Axes& e, double w, const Accelerance& accelerance) const;

  /// Of given friction, which a block that lifts does not have.
  ContactState with_friction(Vector friction, const Axes& e, double w,
                             const Accelerance& accelerance) const;

  /// For given v', 0 at rest: the roof acceleration, and the load that friction must balance.
  struct RoofAndLoad {
    Axes a;
    Load load;
  };
  RoofAndLoad with_acceleration(Vector acceleration, const Axes& e, double w,
                                const Accelerance& accelerance) const;

  /// From an acceleration per cos(slope) to the building's axes.
  Axes to_building(Vector a) const {
    const double c = loading_.cos_slope(), along = c * c * a.s, across = c * a.y;
    return {loading_.cos_azimuth() * along - loading_.sin_azimuth() * across,
            loading_.sin_azimuth() * along + loading_.cos_azimuth() * across};
  }

 private:
  /// Friction per normal force of v = p - lambda f(v); v = 0 if that is a solution.
  Vector implicit_friction(Vector p, double lambda) const {
    return law_.depends_on_speed() ? implicit_friction_by_speed(p, lambda)
                                   : friction_.implicit_friction(p, lambda);
  }
  Vector implicit_friction_by_speed(Vector p, double lambda) const;
  Vector iterate(Vector known, double gamma_h, const Load& uncoupled,
                 const Accelerance& accelerance, Vector guess, double permitted_error,
                 const Axes& e, double w) const;

  TwoAxisLoading loading_;
  FrictionEllipse friction_, at_rest_;
  FrictionLaw law_;
};

}  // namespace glissade::block_detail
