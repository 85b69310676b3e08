// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "glissade/building/motion_table.hpp"

namespace glissade::block_detail {

/// LinearPiece for a drive that is a quartic, in Bernstein form: it stays within the hull of its
/// coefficients and changes sign no more often than they do, so nothing between nodes is missed.
struct QuarticPiece {
  Quartic drive;
  double length_s;

  double at(double y) const {
    const double z = 1.0 - y;
    const double* b = drive.b;
    return ((b[0] * z + 4.0 * b[1] * y) * z + 6.0 * b[2] * y * y) * z * z +
           (4.0 * b[3] * z + b[4] * y) * y * y * y;
  }

  QuarticPiece after(double y) const { return {split(y).right, (1.0 - y) * length_s}; }

  std::optional<double> rise() const {
    if (drive.b[0] > 0.0) return 0.0;
    return first_crossing(1.0);
  }

  std::optional<double> stop(double v0) const {
    if (!may_stop(v0)) return std::nullopt;
    // Speed falls only where the drive is negative: from each fall to the next rise.
    QuarticPiece rest = *this;
    double y = 0.0, speed = v0;
    for (int stretch = 0; stretch < 3; ++stretch) {
      const auto skip = [&](double share) {
        speed = std::max(0.0, speed + rest.gain(share));
        y += share * (1.0 - y);
        rest = rest.after(share);
      };
      if (rest.starts_positive()) {
        const std::optional<double> fall = rest.first_crossing(-1.0);
        if (!fall) return std::nullopt;
        skip(*fall);
        rest.drive.b[0] = 0.0;
      }
      const std::optional<double> rise = rest.first_crossing(1.0);
      const double end = rise.value_or(1.0);
      if (speed + rest.gain(end) <= 0.0) return y + rest.falling_root(speed, end) * (1.0 - y);
      if (!rise) return std::nullopt;
      skip(end);
      rest.drive.b[0] = 0.0;
    }
    return std::nullopt;  // a quartic has no more sign changes
  }

  double gain(double y) const { return length_s * y * left_mean(y).speed; }
  double travel(double y) const {
    const double t = length_s * y;
    return t * t * left_mean(y).way;
  }
  bool may_be_positive() const { return *std::max_element(drive.b, drive.b + 5) > 0.0; }
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

  struct Means {
    double speed, way;
  };
  /// Integral and double integral of the drive from 0 to y over y and y^2: from the coefficients of
  /// the part left of y.
  Means left_mean(double y) const {
    const Quartic q = y == 1.0 ? drive : split(y).left;
    const double* b = q.b;
    return {(b[0] + b[1] + b[2] + b[3] + b[4]) / 5.0,
            (5.0 * b[0] + 4.0 * b[1] + 3.0 * b[2] + 2.0 * b[3] + b[4]) / 30.0};
  }

  bool starts_positive() const {
    for (const double b : drive.b)
      if (b != 0.0) return b > 0.0;
    return false;
  }

  /// The speed is a quintic with these Bernstein coefficients; it stays in their hull.
  bool may_stop(double v0) const {
    double v = v0;
    for (const double b : drive.b) {
      v += 0.2 * length_s * b;
      if (v <= 0.0) return true;
    }
    return false;
  }

  /// First y > 0 from which on sign * drive is positive, where it is not to begin with.
  std::optional<double> first_crossing(double sign, int depth = 0) const {
    int changes = 0;
    bool positive = false;
    for (int k = 1; k < 5; ++k) {
      const bool now = sign * drive.b[k] > 0.0;
      changes += now != positive;
      positive = now;
    }
    if (changes == 0) return std::nullopt;
    if ((changes == 1 && positive) || depth == 40) return root(sign);
    const Halves h = split(0.5);
    const QuarticPiece left{h.left, 0.5 * length_s}, right{h.right, 0.5 * length_s};
    if (const auto y = left.first_crossing(sign, depth + 1)) return 0.5 * *y;
    const auto y = right.first_crossing(sign, depth + 1);
    if (!y) return std::nullopt;
    return 0.5 + 0.5 * *y;
  }

  /// The one zero of the drive where it rises (sign 1) or falls (-1): Newton, held in its bracket.
  double root(double sign) const {
    const auto value = [&](double y) { return sign * at(y); };
    const auto slope = [&](double y) { return sign * slope_at(y); };
    return bracketed_newton(value, slope, 0.0, 1.0, drive.b[0] / (drive.b[0] - drive.b[4]));
  }

  /// The zero of the falling speed v0 + gain(y) in (0, end].
  double falling_root(double v0, double end) const {
    const double v1 = v0 + gain(end);
    const auto value = [&](double y) { return -(v0 + gain(y)); };
    const auto slope = [&](double y) { return -length_s * at(y); };
    return bracketed_newton(value, slope, 0.0, end, end * v0 / (v0 - v1));
  }

  double slope_at(double y) const {
    const double z = 1.0 - y;
    const double* b = drive.b;
    return 4.0 * (((b[1] - b[0]) * z + 3.0 * (b[2] - b[1]) * y) * z * z +
                  (3.0 * (b[3] - b[2]) * z + (b[4] - b[3]) * y) * y * y);
  }

  /// The zero of a function that rises from <= 0 at low to >= 0 at high.
  template <class Value, class Slope>
  static double bracketed_newton(Value value, Slope slope, double low, double high, double y) {
    if (!(y > low && y < high)) y = 0.5 * (low + high);
    for (int i = 0; i < 60; ++i) {
      const double f = value(y);
      if (f == 0.0) return y;
      (f < 0.0 ? low : high) = y;
      const double step = f / slope(y);
      double next = y - step;
      if (!(next >= low && next <= high)) next = 0.5 * (low + high);
      if (std::abs(next - y) < 1e-9) return next;  // converges quadratically: done
      y = next;
    }
    return y;
  }
};

}  // namespace glissade::block_detail
