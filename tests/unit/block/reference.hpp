// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "glissade/block/coupled.hpp"

namespace glissade::test {

/// A history of slide_coupled(), but for its ground.
struct CoupledScene {
  CoupledBuilding building;
  Block block;
  MotionFactors factors;
};

using Real = boost::multiprecision::cpp_bin_float_50;

/// The sliding block in 50 digits, written from the equation of motion alone and without the
/// closed-form roots of slide(): within an interval the velocity is a quadratic of time; it is cut
/// at its turning point, and events are bisected on the monotone pieces. Slopes and coefficients
/// are those of the doubles given.
struct Reference {
  Real slip = 0, down = 0, up = 0, peak_velocity = 0;  ///< in plan; downslope positive, +x if flat
  Real duration = 0;                                   ///< of sliding
  bool uplift = false;
  /// Of the thresholds that are reached, in order: when, and how fast in plan.
  std::vector<Real> crossing_s, crossing_mps;

  Reference(const RoofAcceleration& roof, const Block& block,
            const std::vector<double>& thresholds_m = {}) {
    using std::abs;
    // A roof that falls toward -x is the mirror image of one that falls toward +x.
    const int mirror = block.slope_rad < 0 ? -1 : 1;
    const Real slope = std::abs(block.slope_rad), sine = sin(slope), cosine = cos(slope),
               g = block.gravity_mps2, friction = block.friction.along;
    const std::size_t n = roof.horizontal_mps2.size();
    const auto a = [&](std::size_t i) {
      return i < n ? mirror * Real(roof.horizontal_mps2[i]) * roof.horizontal_factor : Real(0);
    };
    const auto w = [&](std::size_t i) {
      return i < n && !roof.vertical_mps2.empty()
                 ? Real(roof.vertical_mps2[i]) * roof.vertical_factor
                 : Real(0);
    };
    // Acceleration along +x slope for a given direction of friction.
    const auto normal = [&](const Real& ai, const Real& wi) -> Real {
      return (g + wi) * cosine + ai * sine;
    };
    const auto acceleration = [&](const Real& ai, const Real& wi, int sg, const Real& mu) -> Real {
      return (g + wi) * sine - ai * cosine - sg * mu * normal(ai, wi);
    };
    Real v = 0, s = 0, clock = 0;
    int sigma = 0;
    // Over tau from now, slip is s + v tau + n tau^2 / 2 + k tau^3 / 6 and goes one way.
    const auto cross = [&](const Real& now, const Real& tau, const Real& n0, const Real& k) {
      const auto slip_at = [&](const Real& t) -> Real {
        return s + t * (v + t * (n0 / 2 + t * k / 6));
      };
      while (crossing_s.size() < thresholds_m.size() &&
             abs(slip_at(tau)) * cosine >= thresholds_m[crossing_s.size()]) {
        Real lo = 0, hi = tau;
        for (int i = 0; i < 170; ++i) {
          const Real mid = (lo + hi) / 2;
          (abs(slip_at(mid)) * cosine >= thresholds_m[crossing_s.size()] ? hi : lo) = mid;
        }
        crossing_s.push_back(now + hi);
        crossing_mps.push_back(abs(v + hi * (n0 + hi * k / 2)) * cosine);
      }
    };
    const bool free = tan(slope) > friction;
    const auto run = [&](const Real& a0, const Real& w0, const Real& a1, const Real& w1,
                         const Real& h, const Real& mu) {
      Real t = 0;
      const auto acc = [&](const Real& at, int sg) -> Real {
        return acceleration(a0 + (a1 - a0) * at / h, w0 + (w1 - w0) * at / h, sg, mu);
      };
      for (int guard = 0; guard < 40 && t < h; ++guard) {
        if (sigma == 0) {
          // Starts where acc(+1) > 0 or acc(-1) < 0: linear functions, so bisect on their sign at
          // the end.
          const auto first = [&](int sg) -> Real {
            if (sg * acc(t, sg) > 0) return t;
            if (!(sg * acc(h, sg) > 0)) return Real(2) * h;
            Real lo = t, hi = h;
            for (int i = 0; i < 170; ++i) {
              const Real mid = (lo + hi) / 2;
              (sg * acc(mid, sg) > 0 ? hi : lo) = mid;
            }
            return hi;
          };
          const Real td = first(1), tu = first(-1);
          if (td > h && tu > h) return;
          sigma = td <= tu ? 1 : -1;
          t = td <= tu ? td : tu;
          v = 0;
        }
        // Sliding from t: v(tau) = v + n tau + k tau^2/2.
        const Real nn = acc(t, sigma),
                   kk = (acc(h, sigma) - acc(t, sigma)) / (h - t == 0 ? Real(1) : h - t);
        const Real left = h - t;
        const auto velocity = [&](const Real& tau) -> Real {
          return v + nn * tau + kk * tau * tau / 2;
        };
        std::vector<Real> cuts{Real(0)};
        if (kk != 0 && -nn / kk > 0 && -nn / kk < left) cuts.push_back(-nn / kk);
        cuts.push_back(left);
        Real stop = -1;
        for (std::size_t c = 1; c < cuts.size(); ++c) {
          if (sigma * velocity(cuts[c]) > peak_velocity) peak_velocity = sigma * velocity(cuts[c]);
          if (sigma * velocity(cuts[c]) < 0 && stop < 0) {
            Real lo = cuts[c - 1], hi = cuts[c];
            for (int i = 0; i < 170; ++i) {
              const Real mid = (lo + hi) / 2;
              (sigma * velocity(mid) < 0 ? hi : lo) = mid;
            }
            stop = lo;
          }
        }
        const Real tau = stop < 0 ? left : stop;
        cross(clock + t, tau, nn, kk);
        s += v * tau + nn * tau * tau / 2 + kk * tau * tau * tau / 6;
        v = stop < 0 ? velocity(left) : Real(0);
        t += tau;
        duration += tau;
        if (s > down) down = s;
        if (-s > up) up = -s;
        if (stop < 0) return;
        const bool reverses = -sigma * acc(t, -sigma) > 0;
        sigma = reverses ? -sigma : 0;
      }
    };
    // On a lifted block no friction acts: the interval is cut where the normal force, a line, is
    // zero.
    const auto interval = [&](std::size_t sample, const Real& a0, const Real& w0, const Real& a1,
                              const Real& w1) {
      const Real h = roof.dt_s;
      clock = sample * h;
      const bool held0 = normal(a0, w0) >= 0, held1 = normal(a1, w1) >= 0;
      uplift |= !held0 || !held1;
      if (held0 == held1) return run(a0, w0, a1, w1, h, held0 ? friction : Real(0));
      Real lo = 0, hi = 1;
      for (int i = 0; i < 170; ++i) {
        const Real mid = (lo + hi) / 2;
        ((normal(a0 + mid * (a1 - a0), w0 + mid * (w1 - w0)) >= 0) == held0 ? lo : hi) = mid;
      }
      const Real am = a0 + lo * (a1 - a0), wm = w0 + lo * (w1 - w0);
      run(a0, w0, am, wm, lo * h, held0 ? friction : Real(0));
      clock += lo * h;
      run(am, wm, a1, w1, (1 - lo) * h, held1 ? friction : Real(0));
    };
    for (std::size_t i = 0; i + (free ? 1 : 0) < n; ++i)
      interval(i, a(i), w(i), a(i + 1), w(i + 1));
    if (!free && sigma != 0) {
      const Real drive = acceleration(0, 0, sigma, friction);
      if (drive != 0) cross(n * Real(roof.dt_s), -v / drive, drive, 0);
      if (drive != 0) duration += -v / drive;
      if (drive != 0) s += -v * v / (2 * drive);  // without friction on a flat roof it never stops
      if (s > down) down = s;
      if (-s > up) up = -s;
    }
    slip = s * cosine;
    down *= cosine;
    up *= cosine;
    peak_velocity *= cosine;
  }
};

/// From the generator's own bits: the same numbers with every standard library.
inline double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
}

/// A made-up record: filtered noise under an envelope, the same on every machine (std::mt19937 is
/// specified; no distribution of the library is used).
inline std::vector<double> made_up_record(std::size_t n, unsigned seed, double peak_mps2) {
  std::mt19937 generator(seed);
  std::vector<double> a(n);
  double x = 0, y = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double u = static_cast<double>(generator()) / 4294967296.0 - 0.5;
    x += 0.3 * (u - x);
    y += 0.15 * (x - y);
    const double t = static_cast<double>(i) / static_cast<double>(n);
    a[i] = (x - y) * t * std::exp(-4 * t);
  }
  double peak = 0;
  for (const double v : a) peak = std::max(peak, std::abs(v));
  for (double& v : a) v *= peak_mps2 / peak;
  return a;
}

}  // namespace glissade::test
