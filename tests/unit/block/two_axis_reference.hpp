// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "glissade/block/two_axis.hpp"

namespace glissade::test {

/// The block on two axes by another method: the implicit midpoint rule on small equal steps (Moreau
/// 1988), which needs no events: rest is a step that friction shortens to nothing. In the axes of
/// the slope, in the plane itself, with the ellipse's equation solved by bisection. Second order.
struct TwoAxisReference {
  double peak_m = 0.0, peak_along_m = 0.0, peak_across_m = 0.0;
  double along_m = 0.0, across_m = 0.0, path_length_m = 0.0, peak_velocity_mps = 0.0;

  TwoAxisReference(const TwoAxisAcceleration& roof, const TwoAxisBlock& block, int steps) {
    const std::size_t n = roof.horizontal_mps2[0].size();
    const double sine = std::sin(block.slope_rad), cosine = std::cos(block.slope_rad);
    const auto sample = [&](std::span<const double> x, double factor, std::size_t i) {
      return x.empty() || i >= n ? 0.0 : factor * x[i];
    };
    double vs = 0, vy = 0;
    const double h = roof.dt_s / steps;
    for (std::size_t i = 0; i < n || std::hypot(vs, vy) > 0.0; ++i) {
      std::array<double, 2> a1, a2, w;
      for (std::size_t k = 0; k < 2; ++k) {
        a1[k] = sample(roof.horizontal_mps2[0], roof.horizontal_factor, i + k);
        a2[k] = sample(roof.horizontal_mps2[1], roof.horizontal_factor, i + k);
        w[k] = sample(roof.vertical_mps2, roof.vertical_factor, i + k);
      }
      for (int j = 0; j < steps; ++j) {
        const double share = (j + 0.5) / steps;
        const double x = std::lerp(a1[0], a1[1], share), y = std::lerp(a2[0], a2[1], share);
        const double gravity = block.gravity_mps2 + std::lerp(w[0], w[1], share);
        const double as = std::cos(block.azimuth_rad) * x + std::sin(block.azimuth_rad) * y;
        const double ay = std::cos(block.azimuth_rad) * y - std::sin(block.azimuth_rad) * x;
        const double normal = std::max(0.0, gravity * cosine + as * sine);
        // Half a step forward, held back by half a step of friction; the other half mirrors it.
        const double ps = vs + 0.5 * h * (gravity * sine - as * cosine), py = vy - 0.5 * h * ay;
        const auto [ms, my] = held(ps, py, 0.5 * h * normal, block.friction);
        along_m += h * ms * cosine;
        across_m += h * my;
        path_length_m += h * std::hypot(ms * cosine, my);
        vs = 2.0 * ms - vs;
        vy = 2.0 * my - vy;
        if (ms == 0.0 && my == 0.0) vs = vy = 0.0;
        peak_m = std::max(peak_m, std::hypot(along_m, across_m));
        peak_along_m = std::max(peak_along_m, std::abs(along_m));
        peak_across_m = std::max(peak_across_m, std::abs(across_m));
        peak_velocity_mps = std::max(peak_velocity_mps, std::hypot(ms * cosine, my));
      }
    }
  }

 private:
  /// v = p - lambda (mu_s^2 v_s, mu_y^2 v_y) / sigma, sigma = |(mu_s v_s, mu_y v_y)|.
  static std::array<double, 2> held(double ps, double py, double lambda,
                                    const EllipticFriction& mu) {
    const auto beyond = [&](double sigma) {
      return std::hypot(mu.along * ps / (sigma + lambda * mu.along * mu.along),
                        mu.across * py / (sigma + lambda * mu.across * mu.across)) > 1.0;
    };
    if (lambda == 0.0 || mu.along == 0.0) return {ps, py};
    if (!beyond(0.0)) return {0.0, 0.0};
    if (mu.along == mu.across) {
      const double left = 1.0 - lambda * mu.along / std::hypot(ps, py);
      return {left * ps, left * py};
    }
    double low = 0.0, high = std::hypot(mu.along * ps, mu.across * py);
    for (int i = 0; i < 52; ++i) {
      const double middle = 0.5 * (low + high);
      (beyond(middle) ? low : high) = middle;
    }
    return {ps * low / (low + lambda * mu.along * mu.along),
            py * low / (low + lambda * mu.across * mu.across)};
  }
};

}  // namespace glissade::test
