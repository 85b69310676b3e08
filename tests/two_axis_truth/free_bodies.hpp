// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

#include "two_axis_truth/first_negative.hpp"
#include "two_axis_truth/storeys.hpp"
#include "two_axis_truth/two_axis_truth.hpp"

namespace glissade::test {

using Two = std::array<Long, 2>;

inline Long dot(const Two& a, const Two& b) { return a[0] * b[0] + a[1] * b[1]; }
inline Long length(const Two& a) { return std::sqrt(dot(a, a)); }

/// Along the axes of the building u of its floors and its rate; in the plane of the roof, down the
/// slope and across, slip x and velocity v.
struct State {
  std::array<Floors, 2> u{}, rate{};
  Two v{}, x{};
};

/// The free bodies of array and roof over one sample interval (theory.md, 3.1 to 3.5).
class FreeBodies {
 public:
  bool lifted = false;  ///< no friction

  explicit FreeBodies(const TruthScene& scene) : scene_(scene) {
    const Block& block = scene.block;
    sine_ = std::sin(static_cast<Long>(block.slope_rad));
    cosine_ = std::cos(static_cast<Long>(block.slope_rad));
    const Long azimuth = block.azimuth_rad;
    turn_ = {std::cos(azimuth), std::sin(azimuth)};
    mu_ = {block.friction.along, block.friction.across};
    for (std::size_t n = 0; n < 2; ++n) {
      const Mode& o = scene.building.horizontal[n][0];
      if (!scene.storeys[n].masses.empty())
        axis_[n] = Storeys(scene.storeys[n]);
      else if (o.period_s > 0.0)
        axis_[n] = Storeys(2.0L * std::numbers::pi_v<Long> / o.period_s, o.damping_ratio);
      if (moves(n)) ratio_[n] = scene.building.mass_ratio / axis_[n].share(floors(n) - 1);
    }
  }

  Long dt() const { return scene_.dt_s; }
  Long gravity() const { return scene_.block.gravity_mps2; }
  Long cos_slope() const { return cosine_; }
  Long largest_omega() const { return std::max(omega(0), omega(1)); }
  std::size_t floors(std::size_t axis) const { return axis_[axis].floors(); }
  bool moves(std::size_t axis) const { return floors(axis) > 0; }
  Long omega(std::size_t axis) const { return axis_[axis].largest_omega(); }
  /// Gravity alone does not keep it sliding (1.5).
  bool stops() const { return sine_ < mu_[0] * cosine_; }
  Long ground(std::size_t axis, Long t) const { return ground_[axis].at(t / dt()); }

  void load_interval(std::size_t i) {
    const auto ramp = [&](std::span<const double> x, Long factor) {
      const auto sample = [&](std::size_t k) { return k < x.size() ? factor * x[k] : 0.0L; };
      return Ramp{sample(i), sample(i + 1) - sample(i)};
    };
    for (std::size_t n = 0; n < 2; ++n)
      ground_[n] = ramp(scene_.ground_mps2[n], scene_.factors.horizontal[n]);
    vertical_ = ramp(scene_.vertical_mps2, scene_.factors.vertical);
  }

  /// Every |a| to come is so small that the block sticks.
  bool is_settled(const State& y) const {
    Long a = 0;
    for (std::size_t n = 0; n < 2; ++n)
      for (std::size_t i = 0; i < floors(n); ++i)
        a += 1.5L * omega(n) * (omega(n) * std::abs(y.u[n][i]) + std::abs(y.rate[n][i]));
    const Long g = scene_.block.gravity_mps2;
    return length({(g * sine_ + a) / mu_[0], a / mu_[1]}) < g * cosine_ - a;
  }

  /// Friction per normal force (3.4), with the factor of (3.11).
  Two friction(const Two& v) const {
    const FrictionLaw& law = scene_.block.law;
    const Long fast = law.fast_over_slow, size = length({mu_[0] * v[0], mu_[1] * v[1]});
    const Long factor = fast - (fast - 1.0L) * std::exp(-law.rate_s_per_m * length(v));
    return {factor * mu_[0] * mu_[0] * v[0] / size, factor * mu_[1] * mu_[1] * v[1] / size};
  }

  struct Motion {
    std::array<Floors, 2> floor{};  ///< accelerations by the building's axes
    Two block{};                    ///< v'
    Long normal = 0;                ///< N/m
    Two push{};                     ///< of the array on the roof, against its acceleration, over m
  };
  /// (3.1) to (3.3) and (3.9) at time t of the interval with friction f per normal force. With R
  /// the mass ratio to the roof's own mass of each axis that moves: a = E - R N (sin - f_s cos,
  /// -f_y), and N by (3.1).
  Motion contact(Long t, const State& y, Two f) const {
    const Long part = t / dt(), gravity = scene_.block.gravity_mps2 + vertical_.at(part);
    if (lifted) f = {};
    Two e;
    Motion m;
    for (std::size_t n = 0; n < 2; ++n) {
      e[n] = ground_[n].at(part);
      for (std::size_t i = 0; i < floors(n); ++i)
        e[n] = m.floor[n][i] = axis_[n].pull(i, y.u[n], y.rate[n]);
    }
    const Two per_normal = to_building({sine_ - f[0] * cosine_, -f[1]});
    const Two push{ratio_[0] * per_normal[0], ratio_[1] * per_normal[1]};
    m.normal = (gravity * cosine_ + to_slope(e)[0] * sine_) / (1.0L + sine_ * to_slope(push)[0]);
    m.push = {m.normal * per_normal[0], m.normal * per_normal[1]};
    Two roof;
    for (std::size_t n = 0; n < 2; ++n) {
      roof[n] = e[n] - m.normal * push[n];
      if (moves(n)) m.floor[n][floors(n) - 1] = roof[n];
    }
    const Two a = to_slope(roof);
    m.block = {gravity * sine_ - a[0] * cosine_ - m.normal * f[0], -a[1] - m.normal * f[1]};
    return m;
  }
  Motion contact(Long t, const State& y) const { return contact(t, y, friction(y.v)); }

  /// The inertia of floors and array, over the building's mass.
  Long base_shear(std::size_t n, const Motion& m) const {
    Long sum = scene_.building.mass_ratio * m.push[n];
    for (std::size_t i = 0; i < floors(n); ++i) sum += axis_[n].share(i) * m.floor[n][i];
    return sum;
  }

  /// Power series over the fraction x of a piece of length h, with u'' = E - a_g of each floor, E /
  /// (1 + R) - a_g of the roof.
  struct Resting {
    Series u[2][most_floors]{}, roof[2]{}, cone{};  ///< cone (3.5): positive while the block sticks
  };
  Resting resting(Long t, Long h, const State& y) const {
    Resting s;
    for (std::size_t n = 0; n < 2; ++n) {
      const Series ground{ground_[n].at(t / dt()), ground_[n].change * h / dt()};
      s.roof[n] = ground;
      for (std::size_t i = 0; i < floors(n); ++i) {
        s.u[n][i][0] = y.u[n][i];
        s.u[n][i][1] = h * y.rate[n][i];
      }
      for (std::size_t k = 0; k < terms; ++k) {
        const auto next = static_cast<Long>(k + 1);
        Floors u{}, rate{};
        for (std::size_t i = 0; i < floors(n); ++i) {
          u[i] = s.u[n][i][k];
          rate[i] = k + 1 < terms ? next * s.u[n][i][k + 1] / h : 0.0L;
        }
        for (std::size_t i = 0; i < floors(n); ++i) {
          Long a = axis_[n].pull(i, u, rate);
          if (i + 1 == floors(n)) s.roof[n][k] = a /= 1.0L + ratio_[n];
          if (k + 2 < terms) s.u[n][i][k + 2] = h * h * (a - ground[k]) / (next * (next + 1.0L));
        }
      }
    }
    const Series gravity{scene_.block.gravity_mps2 + vertical_.at(t / dt()),
                         vertical_.change * h / dt()};
    Series drive[2], normal;
    for (std::size_t k = 0; k < terms; ++k) {
      const Two a = to_slope({s.roof[0][k], s.roof[1][k]});
      drive[0][k] = (gravity[k] * sine_ - a[0] * cosine_) / mu_[0];
      drive[1][k] = -a[1] / mu_[1];
      normal[k] = scene_.block.law.static_over_sliding * (gravity[k] * cosine_ + a[0] * sine_);
    }
    s.cone = plus(product(normal, normal), -1.0L,
                  plus(product(drive[0], drive[0]), 1.0L, product(drive[1], drive[1])));
    return s;
  }

  /// Direction in which a block begins to slide, as a velocity too small for (3.11): friction is
  /// against the force that resisted it.
  Two release_direction(Long t, const State& y) const {
    const Resting s = resting(t, dt(), y);
    const Two a = to_slope({s.roof[0][0], s.roof[1][0]});
    const Long gravity = scene_.block.gravity_mps2 + vertical_.at(t / dt());
    const Two resisted{(gravity * sine_ - a[0] * cosine_) / (mu_[0] * mu_[0]),
                       -a[1] / (mu_[1] * mu_[1])};
    const Long size = length(resisted);
    return {1e-20L * resisted[0] / size, 1e-20L * resisted[1] / size};
  }

 private:
  /// Linear over the interval.
  struct Ramp {
    Long begin = 0, change = 0;
    Long at(Long part) const { return begin + change * part; }
  };

  Two to_slope(const Two& a) const {
    return {turn_[0] * a[0] + turn_[1] * a[1], turn_[0] * a[1] - turn_[1] * a[0]};
  }
  Two to_building(const Two& a) const {
    return {turn_[0] * a[0] - turn_[1] * a[1], turn_[1] * a[0] + turn_[0] * a[1]};
  }

  const TruthScene& scene_;
  Long sine_ = 0, cosine_ = 1;
  Two turn_{}, mu_{}, ratio_{};
  std::array<Storeys, 2> axis_;
  std::array<Ramp, 2> ground_;
  Ramp vertical_;
};

}  // namespace glissade::test
