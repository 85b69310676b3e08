// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/full_model/building_axis.hpp"

#include <numbers>

namespace glissade::block_detail {

BuildingAxis::BuildingAxis(const Oscillator& oscillator, const Yielding& yielding,
                           double mass_ratio, double piece_s)
    : stuck_mass_(1.0 + mass_ratio) {
  if (oscillator.period_s == 0.0) return;
  omega_ = 2.0 * std::numbers::pi / oscillator.period_s;
  twice_zeta_ = 2.0 * oscillator.damping_ratio;
  yields_ = yielding.yields();
  if (yields_) {
    hardening_ = yielding.hardening_ratio;
    yield_ = yielding.yield_acceleration_mps2;
  }
  phase_ = omega_ * piece_s;
  const double rate = phase_ * (1.0 + twice_zeta_);
  constexpr double last_term = 1e-15;  // of the first: far below the least tolerance, 1e-11
  int terms = 3;
  for (double term = rate * rate * rate / 6.0; term > last_term && terms < Series::most_terms - 3;)
    term *= rate / ++terms;
  terms_ = terms + 1;

  const double root = std::sqrt(stuck_mass_);
  const OscillatorStep step = oscillator_step(phase_ / root, oscillator.damping_ratio / root);
  rest_ = {step.xx,
           step.xy * root,
           step.xy / root,
           step.yy,
           stuck_mass_ * step.x_start,
           stuck_mass_ * step.x_end,
           root * step.y_start,
           root * step.y_end};
}

// In the fraction of the piece, with phase = omega length:
//   dx = phase y,  dy = phase (a - a_ground),  mass a = E - interaction,  dE = -(2 zeta dy + k dx).
AxisSeries BuildingAxis::motion(double length_s, const Ramp& ground, double mass,
                                const Ramp& interaction) const {
  AxisSeries m;
  const double ground_c[2] = {ground.begin, ground.end - ground.begin},
               interaction_c[2] = {interaction.begin, interaction.end - interaction.begin};
  m.x.terms = m.y.terms = m.resisting.terms = terms_;
  if (rigid()) {
    for (int k = 0; k < 2; ++k) {
      m.x.c[k] = m.y.c[k] = 0.0;
      m.resisting.c[k] = mass * ground_c[k] + interaction_c[k];
    }
    m.resisting_bound = std::abs(m.resisting.c[0]) + std::abs(m.resisting.c[1]);
    return m;
  }
  const double phase = omega_ * length_s, per_mass = 1.0 / mass, k_tangent = stiffness();
  m.x.c[0] = x_;
  m.y.c[0] = y_;
  m.resisting.c[0] = resisting();
  const double forcing[2] = {ground_c[0] + interaction_c[0] * per_mass,
                             ground_c[1] + interaction_c[1] * per_mass};
  for (int k = 0; k + 1 < terms_; ++k) {
    const double factor = phase * Series::inverse[k + 1];
    double rise = m.resisting.c[k] * per_mass;
    if (k < 2) rise -= forcing[k];
    m.x.c[k + 1] = factor * m.y.c[k];
    m.y.c[k + 1] = factor * rise;
    m.resisting.c[k + 1] = -(twice_zeta_ * m.y.c[k + 1] + k_tangent * m.x.c[k + 1]);
  }
  // Bounds by the first four terms. From the fourth on, |E_k+1| <= (2 zeta phase / k) |E_k| +
  // (phase^2 / (k (k - 1))) |E_k-1| and x_k+2 is phase^2 / (k + 1) (k + 2) of E_k, with phase (1 +
  // 2 zeta) <= longest_phase = 0.4.
  constexpr double tail_of_e2 = 1.02;  // of E_2 and all it adds to later terms: 1 + 0.4^2 / 12 ...
  constexpr double tail_of_e3 = 1.13;  // of E_3: 1 + 0.4 / 4 + 0.4^2 / 20 ...
  constexpr double x_per_e = 0.0134;   // 0.4^2 / 12
  const auto size = [](const Series& of, int k) { return std::abs(coefficient(of, k)); };
  const double e2 = tail_of_e2 * size(m.resisting, 2), e3 = tail_of_e3 * size(m.resisting, 3);
  m.resisting_bound = size(m.resisting, 0) + size(m.resisting, 1) + e2 + e3;
  m.x_bound = size(m.x, 0) + size(m.x, 1) + size(m.x, 2) + size(m.x, 3) + x_per_e * (e2 + e3);
  return m;
}

double BuildingAxis::next_yield(const AxisSeries& motion) const {
  if (!yields_) return never;
  if (yield_direction_ != 0)
    return first_fall(motion.y, yield_direction_ > 0 ? Sign::plus : Sign::minus);
  Series z = motion.x;
  z.c[0] = z_ - yield_;
  const double up = first_rise(z);
  z.c[0] = z_ + yield_;
  return std::min(up, first_fall(z));
}

void BuildingAxis::follow(const AxisSeries& motion, double fraction, double add_x, double add_y) {
  if (rigid()) return;
  const double x = motion.x.at(fraction) + add_x;
  if (yields_ && yield_direction_ == 0) z_ = std::clamp(z_ + (x - x_), -yield_, yield_);
  x_ = x;
  y_ = motion.y.at(fraction) + add_y;
}

void BuildingAxis::yield() {
  if (yield_direction_ != 0) {
    y_ = yield_direction_ > 0 ? std::min(y_, 0.0) : std::max(y_, 0.0);
    yield_direction_ = 0;
    return;
  }
  yield_direction_ = z_ > 0.0 ? 1 : -1;
  z_ = yield_direction_ * yield_;
}

double BuildingAxis::largest_to_come_mps2() const {
  if (rigid()) return 0.0;
  if (yield_direction_ != 0) return never;
  const double s = spring(), root = std::sqrt(stuck_mass_), zeta = 0.5 * twice_zeta_ / root;
  const Envelope envelope = free_vibration_envelope(s / stuck_mass_, y_ / root, zeta);
  // Elastic about where the spring is without force.
  if (yields_ && !(std::abs(z_ - s) + stuck_mass_ * envelope.amplitude < yield_)) return never;
  return (1.0 + 2.0 * zeta) * envelope.amplitude;
}

}  // namespace glissade::block_detail
