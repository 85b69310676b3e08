// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/contact/building_contact.hpp"

#include <cmath>
#include <numbers>

#include "glissade/block/on_building.hpp"
#include "glissade/core/contract.hpp"

namespace glissade::block_detail {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

EllipticFriction times(const EllipticFriction& mu, double factor) {
  return {factor * mu.along, factor * mu.across};
}

}  // namespace

BuildingContact::BuildingContact(const Block& block)
    : loading_(block),
      friction_(block.friction),
      at_rest_(times(block.friction, block.law.static_over_sliding)),
      law_(block.law) {
  require_finite_scene({}, block, {});
  [[maybe_unused]] const EllipticFriction& mu = block.friction;
  GLISSADE_EXPECTS(mu.along >= 0.0 && mu.across >= 0.0 && (mu.along > 0.0) == (mu.across > 0.0));
  GLISSADE_EXPECTS(std::abs(block.slope_rad) < std::numbers::pi / 2);
  GLISSADE_EXPECTS(block.directions == SlipDirections::both);
  GLISSADE_EXPECTS(law_.is_valid());
}

Accelerance BuildingContact::accelerance(const Axes& by_axis) const {
  const double c = loading_.cos_azimuth(), s = loading_.sin_azimuth(),
               cosine = loading_.cos_slope();
  Accelerance m;
  m.axis = by_axis;
  const double differs = by_axis[1] - by_axis[0];
  m.ss = cosine * cosine * (by_axis[0] + s * s * differs);
  m.sy = cosine * (c * s * differs);
  m.yy = by_axis[0] + c * c * differs;
  m.mean = 0.5 * (m.ss + m.yy);
  const double uneven = std::max(m.ss, m.yy) - m.mean + std::abs(m.sy);
  const double tangent = loading_.tan_slope();
  m.coupling = 2.0 * (uneven + tangent * (m.ss + std::abs(m.sy)) * (tangent + friction_.largest()));
  m.isotropic = m.none() || (loading_.tan_slope() == 0.0 && differs == 0.0);
  return m;
}

bool BuildingContact::is_regular(const Accelerance& m) const {
  const double tangent = loading_.tan_slope(), most = law_.largest_factor();
  const double along = m.ss * friction_.along(), across = m.sy * friction_.across();
  return 1.0 + tangent * (tangent * m.ss - most * std::sqrt(along * along + across * across)) > 0.0;
}

double BuildingContact::friction_bound(const Accelerance& m) const {
  const double tangent = loading_.tan_slope();
  const double mu = law_.largest_factor() * friction_.largest();
  const double reach = std::abs(m.ss) + std::abs(m.sy);
  const double divisor = 1.0 + tangent * (tangent * m.ss - mu * reach);
  const double most = std::max(m.ss, m.yy) + std::abs(m.sy);
  constexpr double least_divisor = 1e-3;  // near singular coupling the bound is as large as useful
  return (most * (tangent + mu) + mu) / std::max(divisor, least_divisor);
}

/// Newton's method on the factor k, with |v| falling by lambda f.v/|v| per k, kept in a bracket:
/// mu(|v|) / mu - k falls with k, with a corner where the block comes to rest.
Vector BuildingContact::implicit_friction_by_speed(Vector p, double lambda) const {
  double low = law_.least_factor(), high = law_.largest_factor();
  double k = factor(p);
  Vector f;
  for (int i = 0; i < 100; ++i) {
    f = friction_.implicit_friction(p, lambda * k);
    const Vector v = p - (lambda * k) * f;
    const double size = length(v), cosine = loading_.cos_slope();
    const double target = law_.factor(cosine * size), rate = law_.factor_rate(cosine * size);
    const double shortens = size > 0.0 ? lambda * dot(f, v) / size : 0.0;
    (target > k ? low : high) = k;
    double next = k - (k - target) / (1.0 + rate * cosine * shortens);
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    const double change = std::abs(next - k);
    k = next;
    if (change <= 4.0 * epsilon * k) break;
  }
  return k * friction_.implicit_friction(p, lambda * k);
}

ContactState BuildingContact::with_friction(Vector friction, const Axes& e, double w,
                                            const Accelerance& m) const {
  const Load uncoupled = loading_.at(e[0], e[1], w);
  if (uncoupled.normal < 0.0) friction = {};
  const Vector pull{loading_.tan_slope() - friction.s, -friction.y};
  const Vector response = m * pull;
  ContactState c;
  c.friction = friction;
  c.normal = uncoupled.normal / (1.0 + loading_.tan_slope() * response.s);
  c.a = uncoupled.drive + c.normal * (response - friction);
  const Axes force = to_building(c.normal * pull);
  c.interaction = {m.axis[0] * force[0], m.axis[1] * force[1]};
  return c;
}

ContactState BuildingContact::slide(Vector known, double gamma_h, const Axes& e, double w,
                                    const Accelerance& m, Vector guess,
                                    double permitted_error) const {
  const Load uncoupled = loading_.at(e[0], e[1], w);
  Vector f;
  if (uncoupled.normal > 0.0) {
    if (m.isotropic)
      f = implicit_friction(known + gamma_h * uncoupled.drive,
                            gamma_h * uncoupled.normal * (1.0 + m.mean));
    else
      f = iterate(known, gamma_h, uncoupled, m, guess, permitted_error, e, w);
  }
  ContactState c = with_friction(f, e, w, m);
  c.v = known + gamma_h * c.a;
  return c;
}

/// The normal force and what is not isotropic in R are taken from the last iterate: each changes
/// little with f.
Vector BuildingContact::iterate(Vector known, double gamma_h, const Load& uncoupled,
                                const Accelerance& m, Vector guess, double permitted_error,
                                const Axes& e, double w) const {
  const double tangent = loading_.tan_slope();
  const Vector slope{tangent, 0.0};
  Vector f = guess;
  double relaxation = 1.0, last = never;
  for (int i = 0; i < 100; ++i) {
    const Vector response = m * (slope - f);
    const double normal = uncoupled.normal / (1.0 + tangent * response.s);
    const Vector p = known + gamma_h * (uncoupled.drive + normal * (response + m.mean * f));
    const double lambda = gamma_h * normal * (1.0 + m.mean);
    if (friction_.excess({p, lambda}) <= 0.0) {
      const RoofAndLoad rests = with_acceleration((-1.0 / gamma_h) * known, e, w, m);
      if (friction_.may_rest(rests.load)) return (1.0 / rests.load.normal) * rests.load.drive;
    }
    const Vector next = implicit_friction(p, lambda), change = next - f;
    const double size = length(change);
    if (size > 0.5 * last) relaxation = 0.5;
    f = f + relaxation * change;
    last = size;
    if (lambda * size * std::min(m.coupling, 1.0) <= permitted_error ||
        size <= 8.0 * epsilon * length(f))
      break;
  }
  return f;
}

Vector BuildingContact::release_acceleration(const Axes& e, double w, const Accelerance& m) const {
  BuildingContact slow = *this;
  slow.law_ = {};
  const RoofAndLoad rests = with_acceleration({}, e, w, m);
  const Vector a = slow.slide({}, 1.0, e, w, m, {}, 0.0).v;
  const double rounding = 16.0 * epsilon * length(rests.load.drive);
  return length(a) > rounding ? a : Vector{};  // on the threshold it has no direction yet
}

BuildingContact::RoofAndLoad BuildingContact::with_acceleration(Vector acceleration, const Axes& e,
                                                                double w,
                                                                const Accelerance& m) const {
  const Axes block = to_building(acceleration);
  RoofAndLoad h;
  for (std::size_t i = 0; i < 2; ++i) h.a[i] = (e[i] - m.axis[i] * block[i]) / (1.0 + m.axis[i]);
  h.load = loading_.at(h.a[0], h.a[1], w);
  h.load.drive = h.load.drive - acceleration;
  return h;
}

}  // namespace glissade::block_detail
