// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "unit/block/on_building_scene.hpp"

namespace glissade::test {

/// The full model by another method: the implicit midpoint rule on small equal steps for block and
/// building together (Moreau 1988), in metres and newtons per mass of the building, by the axes of
/// the building, from the free bodies. Contact is solved by repeated substitution of the force
/// between block and roof. Events are not looked for: rest is a step that friction shortens to
/// nothing, the spring's plastic part a clamp. Second order between events. The vertical is rigid.
struct OnBuildingReference {
  double peak_m = 0.0, along_m = 0.0, across_m = 0.0, path_length_m = 0.0, slipping_s = 0.0;
  std::array<double, 2> base_shear{}, roof_m{};
  std::vector<double> crossing_s;

  OnBuildingReference(const OnBuilding& scene, int steps, double ring_down_s,
                      std::vector<double> thresholds_m = {})
      : scene_(scene),
        sine_(std::sin(scene.block.slope_rad)),
        cosine_(std::cos(scene.block.slope_rad)),
        c_(std::cos(scene.block.azimuth_rad)),
        s_(std::sin(scene.block.azimuth_rad)),
        r_(scene.building.mass_ratio) {
    const std::size_t n = scene.first.size();
    const auto quiet = static_cast<std::size_t>(ring_down_s / scene.dt_s);
    crossing_s.assign(thresholds_m.size(), -1.0);
    const double h = scene.dt_s / steps;
    for (std::size_t i = 0; i < n + quiet; ++i) {
      for (int j = 0; j < steps; ++j) {
        const double share = (j + 0.5) / steps;
        const auto at = [&](const std::vector<double>& x) {
          const auto sample = [&](std::size_t k) { return k < x.size() ? x[k] : 0.0; };
          return scene.factor * std::lerp(sample(i), sample(i + 1), share);
        };
        step(h, {at(scene.first), at(scene.second)}, at(scene.up));
        const double distance = std::hypot(along_m, across_m);
        for (std::size_t k = 0; k < thresholds_m.size(); ++k)
          if (crossing_s[k] < 0.0 && distance >= thresholds_m[k])
            crossing_s[k] = (static_cast<double>(i) + (j + 1.0) / steps) * scene.dt_s;
        peak_m = std::max(peak_m, distance);
      }
    }
  }

 private:
  using Two = std::array<double, 2>;

  double omega(std::size_t k) const {
    return 2.0 * std::numbers::pi / scene_.building.horizontal[k][0].period_s;
  }
  bool rigid(std::size_t k) const { return scene_.building.horizontal[k][0].period_s == 0.0; }
  double mu_factor(double speed) const {
    const FrictionLaw& law = scene_.block.law;
    return law.fast_over_slow - (law.fast_over_slow - 1.0) * std::exp(-law.rate_s_per_m * speed);
  }
  /// The plastic part of a spring that has moved on to u, over the building's mass.
  double plastic(std::size_t k, double u) const {
    const Yielding& y = scene_.building.yielding[k];
    const double z = z_[k] + omega(k) * omega(k) * (u - u_[k]);
    return std::clamp(z, -y.yield_acceleration_mps2, y.yield_acceleration_mps2);
  }
  double spring(std::size_t k, double u) const {
    const Yielding& y = scene_.building.yielding[k];
    const double x = omega(k) * omega(k) * u;
    if (!y.yields()) return x;
    return y.hardening_ratio * x + (1.0 - y.hardening_ratio) * plastic(k, u);
  }

  void step(double h, const Two& ground, double w) {
    const double g = scene_.block.gravity_mps2 + w;
    const EllipticFriction& mu = scene_.block.friction;
    const bool at_rest = v_[0] == 0.0 && v_[1] == 0.0;
    Two force = force_, a{}, middle{}, velocity{};
    double normal = 0.0;
    for (int i = 0; i < 200; ++i) {
      for (std::size_t k = 0; k < 2; ++k) {
        if (rigid(k)) {
          a[k] = ground[k];
          continue;
        }
        // velocity = u' + h/2 (a - ground), a = -2 zeta omega velocity - spring - r force
        const double o = omega(k), z2 = 2.0 * scene_.building.horizontal[k][0].damping_ratio * o;
        const double rest = spring(k, u_[k] + 0.5 * h * middle[k]) + r_ * force[k];
        velocity[k] = (velocity_[k] - 0.5 * h * (rest + ground[k])) / (1.0 + 0.5 * h * z2);
        a[k] = -z2 * velocity[k] - rest;
        middle[k] = velocity[k];
      }
      const double as = c_ * a[0] + s_ * a[1], ay = c_ * a[1] - s_ * a[0];
      normal = g * cosine_ + as * sine_;
      const double ds = g * sine_ - as * cosine_, dy = -ay;
      const double n = std::max(normal, 0.0);
      const double static_size = std::hypot(ds / mu.along, dy / mu.across);
      Two next;
      if (at_rest && static_size <= scene_.block.law.static_over_sliding * n) {
        middle_v_ = {0.0, 0.0};
        next = {ds, dy};
      } else {
        const double k = mu_factor(std::hypot(middle_v_[0], middle_v_[1]));
        const Two p{v_[0] + 0.5 * h * ds, v_[1] + 0.5 * h * dy};
        middle_v_ = held(p, 0.5 * h * n * k);
        next = {(p[0] - middle_v_[0]) / (0.5 * h), (p[1] - middle_v_[1]) / (0.5 * h)};
      }
      const double along = normal * sine_ - next[0] * cosine_, across = -next[1];
      const Two pushes{c_ * along - s_ * across, s_ * along + c_ * across};
      const double change = std::hypot(pushes[0] - force[0], pushes[1] - force[1]);
      force = pushes;
      if (change <= 1e-13 * g) break;
    }
    force_ = force;
    for (std::size_t k = 0; k < 2; ++k) {
      const double carried = a[k] + r_ * force[k];
      base_shear[k] = std::max(base_shear[k], std::abs(carried) / scene_.block.gravity_mps2);
      if (rigid(k)) continue;
      const double end = u_[k] + h * velocity[k];
      if (scene_.building.yielding[k].yields()) z_[k] = plastic(k, end);
      u_[k] = end;
      velocity_[k] = 2.0 * velocity[k] - velocity_[k];
      roof_m[k] = std::max(roof_m[k], std::abs(end));
    }
    along_m += h * middle_v_[0] * cosine_;
    across_m += h * middle_v_[1];
    path_length_m += h * std::hypot(middle_v_[0] * cosine_, middle_v_[1]);
    const bool rests = middle_v_[0] == 0.0 && middle_v_[1] == 0.0;
    if (!rests) slipping_s += h;
    for (std::size_t k = 0; k < 2; ++k) v_[k] = rests ? 0.0 : 2.0 * middle_v_[k] - v_[k];
  }

  /// v = p - lambda (mu_s^2 v_s, mu_y^2 v_y) / sigma, sigma = |(mu_s v_s, mu_y v_y)|, by bisection.
  Two held(const Two& p, double lambda) const {
    const EllipticFriction& mu = scene_.block.friction;
    const auto beyond = [&](double sigma) {
      return std::hypot(mu.along * p[0] / (sigma + lambda * mu.along * mu.along),
                        mu.across * p[1] / (sigma + lambda * mu.across * mu.across)) > 1.0;
    };
    if (lambda == 0.0) return p;
    if (!beyond(0.0)) return {0.0, 0.0};
    if (mu.along == mu.across) {
      const double left = 1.0 - lambda * mu.along / std::hypot(p[0], p[1]);
      return {left * p[0], left * p[1]};
    }
    double low = 0.0, high = std::hypot(mu.along * p[0], mu.across * p[1]);
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (beyond(middle) ? low : high) = middle;
    }
    return {p[0] * low / (low + lambda * mu.along * mu.along),
            p[1] * low / (low + lambda * mu.across * mu.across)};
  }

  const OnBuilding& scene_;
  double sine_, cosine_, c_, s_, r_;
  Two u_{}, velocity_{}, z_{}, v_{}, middle_v_{}, force_{};
};

}  // namespace glissade::test
