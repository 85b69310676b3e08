// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "block/contact/contact.hpp"
#include "block/contact/line.hpp"
#include "glissade/building/motion_table.hpp"

namespace glissade::block_detail {

/// LinearPiece for a drive that is a quartic, in Bernstein form: it stays within the hull of its
/// coefficients and changes sign no more often than they do, so no event between nodes is missed.
struct QuarticPiece {
  struct Interval {
    Quartic a, w;
    bool vertical;  ///< with w
  };
  Quartic drive{};
  double length_s = 0.0;

  QuarticPiece() = default;
  QuarticPiece(const Quartic& values, double length) : drive(values), length_s(length) {}
  QuarticPiece(const DriveLine& line, const Interval& roof, double length) {
    set(line, roof, length);
  }

  // Set and divided in place: copies would stall on store forwarding.
  void set(const DriveLine& line, const Interval& roof, double length) {
    length_s = length;
    for (int k = 0; k < 5; ++k) drive.b[k] = line.a * roof.a.b[k] + line.constant;
    if (!roof.vertical) return;
    for (int k = 0; k < 5; ++k) drive.b[k] += line.w * roof.w.b[k];
  }

  double at(double tau) const { return Powers(drive).value(tau); }

  /// Keeps the part after tau. de Casteljau.
  void keep_after(double tau) {
    double* const b = drive.b;
    for (int level = 4; level > 0; --level)
      for (int k = 0; k < level; ++k) b[k] += tau * (b[k + 1] - b[k]);
    length_s *= 1.0 - tau;
  }

  double rise() const {
    if (drive.b[0] > 0.0) return 0.0;
    return first_crossing(1.0);
  }

  double stop(double v0) const {
    if (!may_stop(v0)) return never;
    if (!may_be_positive()) return falling_root(v0, 1.0);
    // The speed decreases only where the drive is negative.
    QuarticPiece rest = *this;
    double tau = 0.0, speed = v0;
    const auto skip = [&](double fraction) {
      speed = std::max(0.0, speed + rest.gain(fraction));
      tau += fraction * (1.0 - tau);
      rest.keep_after(fraction);
      rest.begin_at_zero();
    };
    for (int stretch = 0; stretch < 3; ++stretch) {  // a quartic has no more sign changes
      if (rest.starts_positive()) {
        const double fall = rest.first_crossing(-1.0);
        if (fall == never) return never;
        skip(fall);
      }
      const double rise = rest.first_crossing(1.0), end = std::min(rise, 1.0);
      if (speed + rest.gain(end) <= 0.0) return tau + rest.falling_root(speed, end) * (1.0 - tau);
      if (rise == never) return never;
      skip(end);
    }
    return never;
  }

  /// Speed and displacement from rest.
  double gain(double tau) const {
    const Quartic q = tau == 1.0 ? drive : split(tau).left;
    return 0.2 * length_s * tau * ((q.b[0] + q.b[1]) + (q.b[2] + q.b[3]) + q.b[4]);
  }
  double travel(double tau) const {
    const Quartic q = tau == 1.0 ? drive : split(tau).left;
    const double t = length_s * tau;
    return t * t / 30.0 * ((5.0 * q.b[0] + 4.0 * q.b[1]) + (3.0 * q.b[2] + 2.0 * q.b[3]) + q.b[4]);
  }
  bool may_be_positive() const {
    return std::max(std::max(drive.b[0], drive.b[4]),
                    std::max(drive.b[1], std::max(drive.b[2], drive.b[3]))) > 0.0;
  }
  void begin_at_zero() { drive.b[0] = 0.0; }
  void begin_at_most_zero() { drive.b[0] = std::min(drive.b[0], 0.0); }

 private:
  struct Halves {
    Quartic left, right;
  };
  /// de Casteljau.
  Halves split(double tau) const {
    Halves h;
    Quartic c = drive;
    for (int level = 0; level < 5; ++level) {
      h.left.b[level] = c.b[0];
      h.right.b[4 - level] = c.b[4 - level];
      for (int k = 0; k < 4 - level; ++k) c.b[k] += tau * (c.b[k + 1] - c.b[k]);
    }
    return h;
  }

  /// Coefficients of the powers of tau, for Halley's method.
  struct Powers {
    double c0, c1, c2, c3, c4;

    explicit Powers(const Quartic& q) {
      const double* b = q.b;
      c0 = b[0];
      c1 = 4.0 * (b[1] - b[0]);
      c2 = 6.0 * ((b[2] - b[1]) - (b[1] - b[0]));
      c3 = 4.0 * ((b[3] - b[0]) - 3.0 * (b[2] - b[1]));
      c4 = (b[4] - b[3]) - 3.0 * (b[3] - b[2]) + 3.0 * (b[2] - b[1]) - (b[1] - b[0]);
    }
    double value(double tau) const { return c0 + tau * (c1 + tau * (c2 + tau * (c3 + tau * c4))); }
    double slope(double tau) const {
      return c1 + tau * (2.0 * c2 + tau * (3.0 * c3 + tau * (4.0 * c4)));
    }
    double bend(double tau) const { return 2.0 * c2 + tau * (6.0 * c3 + tau * (12.0 * c4)); }
    double integral(double tau) const {
      constexpr double third = 1.0 / 3.0;
      return tau *
             (c0 + tau * (0.5 * c1 + tau * (third * c2 + tau * (0.25 * c3 + tau * (0.2 * c4)))));
    }
  };

  bool starts_positive() const {
    for (const double b : drive.b)
      if (b != 0.0) return b > 0.0;
    return false;
  }

  /// The speed is a quintic and stays in the hull of its Bernstein coefficients.
  bool may_stop(double v0) const {
    const double* b = drive.b;
    const double fifth_s = 0.2 * length_s, v1 = v0 + fifth_s * b[0], v2 = v1 + fifth_s * b[1],
                 v3 = v2 + fifth_s * b[2], v4 = v3 + fifth_s * b[3], v5 = v4 + fifth_s * b[4];
    return std::min(std::min(v1, v2), std::min(v3, v4)) < 0.0 || v5 <= 0.0;
  }

  /// First tau > 0 from which on sign * drive is positive, if it is not at the start.
  double first_crossing(double sign, int depth = 0) const {
    const double* b = drive.b;
    const bool p1 = sign * b[1] > 0.0, p2 = sign * b[2] > 0.0, p3 = sign * b[3] > 0.0,
               p4 = sign * b[4] > 0.0;
    const int changes = p1 + (p1 != p2) + (p2 != p3) + (p3 != p4);
    if (changes == 0) return never;
    if ((changes == 1 && p4) || depth == 40) return root();
    const Halves h = split(0.5);
    const QuarticPiece left{h.left, 0.5 * length_s}, right{h.right, 0.5 * length_s};
    const double tau = left.first_crossing(sign, depth + 1);
    return tau != never ? 0.5 * tau : 0.5 + 0.5 * right.first_crossing(sign, depth + 1);
  }

  /// The single zero of the drive, to about 1e-9: the drive is zero there, so that the errors of
  /// speed and displacement are of second and third order.
  double root() const {
    const Powers p(drive);
    const double* b = drive.b;
    return zero(
        [&](double tau) {
          return Jet{p.value(tau), p.slope(tau), p.bend(tau)};
        },
        {b[0], 4.0 * (b[1] - b[0])}, {b[4], 4.0 * (b[4] - b[3])}, 1.0, 1e-3);
  }

  /// The zero of the decreasing speed v0 + gain(tau) in (0, end].
  double falling_root(double v0, double end) const {
    const Powers p(drive);
    const double v = v0 / length_s;
    return zero(
        [&](double tau) {
          return Jet{v + p.integral(tau), p.value(tau), p.slope(tau)};
        },
        {v, drive.b[0]}, {v + p.integral(end), p.value(end)}, end, 1e-4);
  }

  /// Value and derivatives of a function.
  struct Jet {
    double value, slope, bend = 0.0;
  };

  /// The single zero in [0, high] of a function with the given ends: Halley's method, kept in its
  /// bracket. It starts from the Hermite cubic of the inverse function, with an error of about
  /// 1e-4, and ends with a step below `enough`, with an error of about its cube.
  template <class Function>
  static double zero(Function function, const Jet& begin, const Jet& end, double high,
                     double enough) {
    const double rise = end.value - begin.value, x = -begin.value / rise, z = 1.0 - x;
    const double m0 = rise / (begin.slope * high), m1 = rise / (end.slope * high);
    double low = 0.0, tau = high * (x * x * (3.0 - 2.0 * x) + x * z * (z * m0 - x * m1));
    if (!(tau > low && tau < high)) tau = high * x;
    if (!(tau > low && tau < high)) tau = 0.5 * high;
    for (int i = 0; i < 60; ++i) {
      const Jet f = function(tau);
      if (f.value == 0.0) return tau;
      ((f.value > 0.0) == (rise > 0.0) ? high : low) = tau;
      const double step = 2.0 * f.value * f.slope / (2.0 * f.slope * f.slope - f.value * f.bend);
      const double next = tau - step;
      const bool inside = next >= low && next <= high;
      if (inside && std::abs(step) < enough) return next;
      tau = inside ? next : 0.5 * (low + high);
    }
    return tau;
  }
};

}  // namespace glissade::block_detail
