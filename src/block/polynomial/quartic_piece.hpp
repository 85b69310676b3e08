// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "block/contact/contact.hpp"
#include "block/events/sliding_block.hpp"
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

  double at(double y) const { return Powers(drive).value(y); }

  /// Keeps the part after y. de Casteljau.
  void cut(double y) {
    double* const b = drive.b;
    for (int level = 4; level > 0; --level)
      for (int k = 0; k < level; ++k) b[k] += y * (b[k + 1] - b[k]);
    length_s *= 1.0 - y;
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
    double y = 0.0, speed = v0;
    const auto skip = [&](double share) {
      speed = std::max(0.0, speed + rest.gain(share));
      y += share * (1.0 - y);
      rest.cut(share);
      rest.begin_at_zero();
    };
    for (int stretch = 0; stretch < 3; ++stretch) {  // a quartic has no more sign changes
      if (rest.starts_positive()) {
        const double fall = rest.first_crossing(-1.0);
        if (fall == never) return never;
        skip(fall);
      }
      const double rise = rest.first_crossing(1.0), end = std::min(rise, 1.0);
      if (speed + rest.gain(end) <= 0.0) return y + rest.falling_root(speed, end) * (1.0 - y);
      if (rise == never) return never;
      skip(end);
    }
    return never;
  }

  /// Speed and displacement from rest.
  double gain(double y) const {
    const Quartic q = y == 1.0 ? drive : split(y).left;
    return 0.2 * length_s * y * ((q.b[0] + q.b[1]) + (q.b[2] + q.b[3]) + q.b[4]);
  }
  double travel(double y) const {
    const Quartic q = y == 1.0 ? drive : split(y).left;
    const double t = length_s * y;
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
  Halves split(double y) const {
    Halves h;
    Quartic c = drive;
    for (int level = 0; level < 5; ++level) {
      h.left.b[level] = c.b[0];
      h.right.b[4 - level] = c.b[4 - level];
      for (int k = 0; k < 4 - level; ++k) c.b[k] += y * (c.b[k + 1] - c.b[k]);
    }
    return h;
  }

  /// Coefficients of the powers of y, for Halley's method.
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
    double value(double y) const { return c0 + y * (c1 + y * (c2 + y * (c3 + y * c4))); }
    double slope(double y) const { return c1 + y * (2.0 * c2 + y * (3.0 * c3 + y * (4.0 * c4))); }
    double bend(double y) const { return 2.0 * c2 + y * (6.0 * c3 + y * (12.0 * c4)); }
    double integral(double y) const {
      constexpr double third = 1.0 / 3.0;
      return y * (c0 + y * (0.5 * c1 + y * (third * c2 + y * (0.25 * c3 + y * (0.2 * c4)))));
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
    const double share = 0.2 * length_s, v1 = v0 + share * b[0], v2 = v1 + share * b[1],
                 v3 = v2 + share * b[2], v4 = v3 + share * b[3], v5 = v4 + share * b[4];
    return std::min(std::min(v1, v2), std::min(v3, v4)) < 0.0 || v5 <= 0.0;
  }

  /// First y > 0 from which on sign * drive is positive, if it is not at the start.
  double first_crossing(double sign, int depth = 0) const {
    const double* b = drive.b;
    const bool p1 = sign * b[1] > 0.0, p2 = sign * b[2] > 0.0, p3 = sign * b[3] > 0.0,
               p4 = sign * b[4] > 0.0;
    const int changes = p1 + (p1 != p2) + (p2 != p3) + (p3 != p4);
    if (changes == 0) return never;
    if ((changes == 1 && p4) || depth == 40) return root();
    const Halves h = split(0.5);
    const QuarticPiece left{h.left, 0.5 * length_s}, right{h.right, 0.5 * length_s};
    const double y = left.first_crossing(sign, depth + 1);
    return y != never ? 0.5 * y : 0.5 + 0.5 * right.first_crossing(sign, depth + 1);
  }

  /// The single zero of the drive, to about 1e-9: the drive is zero there, so that the errors of
  /// speed and displacement are of second and third order.
  double root() const {
    const Powers p(drive);
    const double* b = drive.b;
    return zero(
        [&](double y) {
          return Jet{p.value(y), p.slope(y), p.bend(y)};
        },
        {b[0], 4.0 * (b[1] - b[0])}, {b[4], 4.0 * (b[4] - b[3])}, 1.0, 1e-3);
  }

  /// The zero of the decreasing speed v0 + gain(y) in (0, end].
  double falling_root(double v0, double end) const {
    const Powers p(drive);
    const double v = v0 / length_s;
    return zero(
        [&](double y) {
          return Jet{v + p.integral(y), p.value(y), p.slope(y)};
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
    double low = 0.0, y = high * (x * x * (3.0 - 2.0 * x) + x * z * (z * m0 - x * m1));
    if (!(y > low && y < high)) y = high * x;
    if (!(y > low && y < high)) y = 0.5 * high;
    for (int i = 0; i < 60; ++i) {
      const Jet f = function(y);
      if (f.value == 0.0) return y;
      ((f.value > 0.0) == (rise > 0.0) ? high : low) = y;
      const double step = 2.0 * f.value * f.slope / (2.0 * f.slope * f.slope - f.value * f.bend);
      const double next = y - step;
      const bool inside = next >= low && next <= high;
      if (inside && std::abs(step) < enough) return next;
      y = inside ? next : 0.5 * (low + high);
    }
    return y;
  }
};

}  // namespace glissade::block_detail
