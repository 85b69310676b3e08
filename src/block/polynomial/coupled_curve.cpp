// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/polynomial/coupled_curve.hpp"

#include <algorithm>
#include <cmath>

namespace glissade::block_detail {
namespace {

/// exp(p) - 1 for |p| up to 2e-4.
Amplitude small_growth(Amplitude p) {
  return p + p * (0.5 * p + p * ((1.0 / 6.0) * p + (1.0 / 24.0) * (p * p)));
}

}  // namespace

BoundedCurve::BoundedCurve(const Curve& f, const RegimeOscillator& regime, double length,
                           Amplitude at_end)
    : f_(f), regime_(regime), length_(length) {
  begin_ = f.c0 + f.b.re;
  end_ = (f.c0 + (f.c1 + f.c2 * length) * length) + real(f.b, at_end);
  const double size = f.b.size(), phase = regime.phase * length, second = size * phase * phase;
  deviation_ = 0.125 * (second + 2.0 * std::abs(f.c2) * length * length);
  if (is_below_zero()) return;
  const Amplitude b_slope = f.b * regime.s_dt;
  begin_slope_ = length * (f.c1 + b_slope.re);
  end_slope_ = length * ((f.c1 + 2.0 * f.c2 * length) + real(b_slope, at_end));
  slope_deviation_ = 0.125 * second * phase;
  largest_third_ = size * regime.phase * regime.phase * regime.phase;
  cubic_error_ = second * phase * phase / 384.0;
}

Proof BoundedCurve::proof() const {
  if (is_below_zero()) return Proof::negative;
  if (!(begin_ < 0.0)) return Proof::unknown;
  if (end_ > 0.0) return never_falls() ? Proof::rises : Proof::unknown;
  if (!(end_ < 0.0)) return Proof::unknown;
  if (never_falls() || never_rises() || highest_of_cubic() + cubic_error_ < 0.0)
    return Proof::negative;
  return Proof::unknown;
}

double BoundedCurve::highest_of_cubic() const {
  const double rise = end_ - begin_;
  // slope = begin_slope + 2 b tau + 3 c tau^2
  const double b = 3.0 * rise - 2.0 * begin_slope_ - end_slope_,
               c = begin_slope_ + end_slope_ - 2.0 * rise;
  const double root = std::sqrt(std::max(b * b - 3.0 * c * begin_slope_, 0.0));
  const double q = -(b + std::copysign(root, b));
  double most = upper(begin_, end_);
  for (const double tau : {begin_slope_ / q, q / (3.0 * c)})
    if (tau > 0.0 && tau < 1.0)
      most = std::max(most, begin_ + tau * (begin_slope_ + tau * (b + tau * c)));
  return most;
}

/// The cubic's root, nearly.
double BoundedCurve::first_guess() const {
  const double rise = end_ - begin_;
  const double b = 3.0 * rise - 2.0 * begin_slope_ - end_slope_,
               c = begin_slope_ + end_slope_ - 2.0 * rise;
  double tau = -begin_ / rise;
  for (int i = 0; i < 3; ++i) {
    const double value = begin_ + tau * (begin_slope_ + tau * (b + tau * c)),
                 slope = begin_slope_ + tau * (2.0 * b + tau * 3.0 * c);
    tau = std::clamp(tau - value / slope, 0.0, 1.0);
  }
  return tau * length_;
}

BoundedCurve::Root BoundedCurve::root() const {
  double t = first_guess();
  Amplitude power = regime_.after(t).power;
  for (int i = 0; i < 20; ++i) {
    const Amplitude free = f_.b * power, rate = free * regime_.s_dt, bend = rate * regime_.s_dt;
    const double value = (f_.c0 + (f_.c1 + f_.c2 * t) * t) + free.re,
                 slope = (f_.c1 + 2.0 * f_.c2 * t) + rate.re, curve = 2.0 * f_.c2 + bend.re;
    // Halley's method: it trebles the right digits.
    const double step = -2.0 * value * slope / (2.0 * slope * slope - value * curve);
    const double next = std::clamp(t + step, 0.0, length_), taken = next - t;
    if (!(std::abs(taken) <= 1.0)) break;
    t = next;
    const double bent = 0.5 * curve / slope, error = bent * bent + largest_third_ / std::abs(slope);
    if (taken * taken * std::abs(taken) * error <= 1e-17 && std::abs(taken) <= 1e-4)
      return {t, power + power * small_growth(taken * regime_.s_dt), true};
    power = regime_.after(t).power;
  }
  return {t, power, false};
}

}  // namespace glissade::block_detail
