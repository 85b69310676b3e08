// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupled_link.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glissade/core/contract.hpp"

namespace glissade::bench {
namespace {

constexpr double stiffness_per_weight_1pm = 1e5;  // 100 N/mm for 1 N
constexpr double longest_ring_down_s = 120.0;

/// Newmark's average acceleration of one degree of freedom.
struct Motion {
  double x = 0.0, v = 0.0, a = 0.0;

  // At the step's end, but for what the acceleration there adds: h^2/4 and h/2 of it.
  double next_x(double h) const { return x + h * (v + 0.25 * h * a); }
  double next_v(double h) const { return v + 0.5 * h * a; }
  void accelerate(double h, double next) {
    x = next_x(h) + 0.25 * h * h * next;
    v = next_v(h) + 0.5 * h * next;
    a = next;
  }
};

class LinkOnBuilding {
 public:
  LinkOnBuilding(const CoupledBuilding& building, const Block& block)
      : omega_(2.0 * std::numbers::pi / building.horizontal.period_s),
        zeta_(building.horizontal.damping_ratio),
        r_(building.mass_ratio),
        mu_(block.friction),
        sine_(std::sin(block.slope_rad)),
        cosine_(std::cos(block.slope_rad)),
        stiffness_(stiffness_per_weight_1pm * block.gravity_mps2) {
    slip_.x = block.gravity_mps2 * sine_ / stiffness_;
  }

  /// To the ground's acceleration and gravity at the step's end.
  void step(double h, double ground, double gravity) {
    const double spring = stiffness_ * (slip_.next_x(h) - slider_);
    solve(h, ground, cosine_, 1.0 + 0.25 * h * h * stiffness_,
          gravity * sine_ - cosine_ * ground - spring);
    const double trial = spring + stiffness_ * 0.25 * h * h * next_slip_;
    const double mu = normal(ground, gravity) > 0.0 ? mu_ : 0.0;
    if (std::abs(trial) > mu * normal(ground, gravity)) {
      const double friction = std::copysign(mu, trial);
      solve(h, ground, cosine_ + friction * sine_, 1.0,
            gravity * sine_ - cosine_ * ground - friction * (gravity * cosine_ + ground * sine_));
      const double force = friction * normal(ground, gravity);
      slider_ = slip_.next_x(h) + 0.25 * h * h * next_slip_ - force / stiffness_;
      peak_m_ = std::max(peak_m_, std::abs(slider_m()));
    }
    roof_.accelerate(h, next_roof_);
    slip_.accelerate(h, next_slip_);
  }

  double slider_m() const { return slider_ * cosine_; }
  double peak_m() const { return peak_m_; }
  /// A bound on the roof's acceleration in free vibration.
  double amplitude_mps2() const {
    return (1.0 + 2.0 * zeta_) * omega_ * std::hypot(omega_ * roof_.x, roof_.v);
  }

 private:
  /// The roof's equation and the block's: by_roof u'' + by_slip s'' = right.
  void solve(double h, double ground, double by_roof, double by_slip, double right) {
    const double roof = 1.0 + r_ + h * omega_ * (zeta_ + 0.25 * h * omega_), slip = r_ * cosine_;
    const double load =
        -(1.0 + r_) * ground - omega_ * (2.0 * zeta_ * roof_.next_v(h) + omega_ * roof_.next_x(h));
    const double determinant = roof * by_slip - slip * by_roof;
    next_roof_ = (load * by_slip - slip * right) / determinant;
    next_slip_ = (roof * right - load * by_roof) / determinant;
  }

  double normal(double ground, double gravity) const {
    return gravity * cosine_ + (next_roof_ + ground) * sine_;
  }

  double omega_, zeta_, r_, mu_, sine_, cosine_, stiffness_;
  Motion roof_, slip_;
  double slider_ = 0.0, peak_m_ = 0.0;
  double next_roof_ = 0.0, next_slip_ = 0.0;
};

}  // namespace

double coupled_link_peak_m(const GroundMotion& ground, const MotionFactors& factors,
                           const CoupledBuilding& building, const Block& block, int substeps) {
  GLISSADE_EXPECTS(building.horizontal.period_s > 0.0 && !building.yielding.yields());
  GLISSADE_EXPECTS(block.friction > std::tan(std::abs(block.slope_rad)));
  const auto at = [](std::span<const double> samples, double factor, std::size_t i) {
    return i < samples.size() ? factor * samples[i] : 0.0;
  };
  LinkOnBuilding body(building, block);
  const double h = ground.dt_s / substeps;
  const auto interval = [&](std::size_t i) {
    const auto a = [&](std::size_t k) { return at(ground.horizontal_mps2, factors.horizontal, k); };
    const auto w = [&](std::size_t k) { return at(ground.vertical_mps2, factors.vertical, k); };
    for (int part = 1; part <= substeps; ++part) {
      const double share = static_cast<double>(part) / substeps;
      body.step(h, a(i) + share * (a(i + 1) - a(i)),
                block.gravity_mps2 + w(i) + share * (w(i + 1) - w(i)));
    }
  };
  const std::size_t n = ground.horizontal_mps2.size();
  for (std::size_t i = 0; i < n; ++i) interval(i);
  const auto longest = static_cast<std::size_t>(longest_ring_down_s / ground.dt_s);
  for (std::size_t i = 0; i < longest; ++i) {
    const double before_m = body.slider_m();
    interval(n + i);
    if (body.slider_m() == before_m && body.amplitude_mps2() < 0.5 * yield_acceleration_mps2(block))
      break;
  }
  return body.peak_m();
}

}  // namespace glissade::bench
