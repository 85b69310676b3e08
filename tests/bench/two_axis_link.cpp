// SPDX-License-Identifier: GPL-3.0-or-later
#include "two_axis_link.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glissade/block/slide.hpp"
#include "glissade/core/contract.hpp"

namespace glissade::bench {
namespace {

constexpr double stiffness_per_weight_1pm = 1e5;  // 100 N/mm for 1 N
constexpr double longest_ring_down_s = 120.0;

struct Vector {
  double x = 0.0, y = 0.0;
};
Vector operator+(Vector p, Vector q) { return {p.x + q.x, p.y + q.y}; }
Vector operator-(Vector p, Vector q) { return {p.x - q.x, p.y - q.y}; }
Vector operator*(double k, Vector p) { return {k * p.x, k * p.y}; }

/// Newmark's explicit step.
struct Motion {
  Vector x, v, a;
  void predict(double h) {
    v = v + 0.5 * h * a;
    x = x + h * v;
  }
  void correct(double h, Vector next) {
    v = v + 0.5 * h * next;
    a = next;
  }
};

class LinkOnBuilding {
 public:
  LinkOnBuilding(const BiaxialBuilding& building, const Block& block)
      : rigid_(building.horizontal[0][0].period_s == 0.0),
        omega_{omega(building.horizontal[0]), omega(building.horizontal[1])},
        damping_{2.0 * building.horizontal[0][0].damping_ratio * omega_.x,
                 2.0 * building.horizontal[1][0].damping_ratio * omega_.y},
        r_(rigid_ ? 0.0 : building.mass_ratio),
        mu_(block.friction.along),
        sine_(std::sin(block.slope_rad)),
        cosine_(std::cos(block.slope_rad)),
        fall_{std::cos(block.azimuth_rad), std::sin(block.azimuth_rad)},
        stiffness_(stiffness_per_weight_1pm * block.gravity_mps2),
        force_{block.gravity_mps2 * sine_, 0.0},
        normal_(block.gravity_mps2 * cosine_) {}

  /// To the ground's acceleration and gravity at the step's end.
  void step(double h, Vector ground, double gravity) {
    const Vector before = slip_.x;
    roof_.predict(h);
    slip_.predict(h);
    shear(slip_.x - before);

    Vector roof = to_slope(ground);
    if (!rigid_) {
      const Vector pull = to_slope({-damping_.x * roof_.v.x - omega_.x * omega_.x * roof_.x.x,
                                    -damping_.y * roof_.v.y - omega_.y * omega_.y * roof_.x.y});
      roof = {(pull.x - r_ * cosine_ * (gravity * sine_ - force_.x)) / (1.0 + r_ * sine_ * sine_),
              pull.y + r_ * force_.y};
    }
    normal_ = std::max(0.0, gravity * cosine_ + roof.x * sine_);
    slip_.correct(h, {gravity * sine_ - roof.x * cosine_ - force_.x, -roof.y - force_.y});
    roof_.correct(h, to_building(roof) - ground);
  }

  Vector slider() const { return slider_; }
  double peak_m() const { return peak_m_; }
  /// A bound on the roof's acceleration in free vibration.
  double amplitude_mps2() const {
    return rigid_ ? 0.0
                  : 1.2 * std::hypot(omega_.x * std::hypot(omega_.x * roof_.x.x, roof_.v.x),
                                     omega_.y * std::hypot(omega_.y * roof_.x.y, roof_.v.y));
  }

 private:
  static double omega(const Modes& one_mass) {
    return one_mass.rigid() ? 0.0 : 2.0 * std::numbers::pi / one_mass.period_s();
  }
  Vector to_slope(Vector p) const {
    return {fall_.x * p.x + fall_.y * p.y, fall_.x * p.y - fall_.y * p.x};
  }
  Vector to_building(Vector p) const {
    return {fall_.x * p.x - fall_.y * p.y, fall_.y * p.x + fall_.x * p.y};
  }

  /// The isolator's force after it has been moved on; beyond the circle the slider slips.
  void shear(Vector moved) {
    const Vector trial = force_ + stiffness_ * moved;
    const double size = std::hypot(trial.x, trial.y), most = mu_ * normal_;
    force_ = size > most ? (most / size) * trial : trial;
    if (size <= most) return;
    slider_ = slider_ + (1.0 / stiffness_) * (trial - force_);
    peak_m_ = std::max(peak_m_, std::hypot(slider_.x * cosine_, slider_.y));
  }

  bool rigid_;
  Vector omega_, damping_;
  double r_, mu_, sine_, cosine_;
  Vector fall_;
  double stiffness_;
  Motion roof_, slip_;  ///< by the building's axes; by the slope's
  Vector force_, slider_;
  double normal_, peak_m_ = 0.0;
};

}  // namespace

double two_axis_link_peak_m(const SampledGround& ground, const MotionFactors& factors,
                            const BiaxialBuilding& building, const Block& block, int substeps) {
  [[maybe_unused]] const auto rigid = [&](std::size_t n) {
    return building.horizontal[n][0].period_s == 0.0;
  };
  GLISSADE_EXPECTS(rigid(0) == rigid(1) && block.friction.along == block.friction.across);
  GLISSADE_EXPECTS(block.friction.along > std::tan(block.slope_rad));
  const auto at = [](std::span<const double> samples, double factor, std::size_t i) {
    return i < samples.size() ? factor * samples[i] : 0.0;
  };
  const double gravity = block.gravity_mps2;
  LinkOnBuilding body(building, block);
  const double h = ground.dt_s / substeps;
  const auto node = [&](std::size_t i) {
    return Vector{at(ground.horizontal_mps2[0], factors.horizontal[0], i),
                  at(ground.horizontal_mps2[1], factors.horizontal[1], i)};
  };
  const auto interval = [&](std::size_t i) {
    const Vector a0 = node(i), a1 = node(i + 1);
    const double w0 = at(ground.vertical_mps2, factors.vertical, i),
                 w1 = at(ground.vertical_mps2, factors.vertical, i + 1);
    for (int part = 1; part <= substeps; ++part) {
      const double share = static_cast<double>(part) / substeps;
      body.step(h, a0 + share * (a1 - a0), gravity + w0 + share * (w1 - w0));
    }
  };
  const std::size_t n = ground.horizontal_mps2[0].size();
  for (std::size_t i = 0; i < n; ++i) interval(i);
  const double quiet_mps2 = 0.5 * yield_acceleration_mps2({block.friction.along, block.slope_rad});
  const auto longest = static_cast<std::size_t>(longest_ring_down_s / ground.dt_s);
  for (std::size_t i = 0; i < longest; ++i) {
    const Vector before = body.slider();
    interval(n + i);
    const Vector moved = body.slider() - before;
    if (moved.x == 0.0 && moved.y == 0.0 && body.amplitude_mps2() < quiet_mps2) break;
  }
  return body.peak_m();
}

}  // namespace glissade::bench
