// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "glissade/core/contract.hpp"
#include "glissade/motion/motion_processing.hpp"

namespace glissade {
namespace {

/// y_n = b0 x_n + b1 x_(n-1) + b2 x_(n-2) - a1 y_(n-1) - a2 y_(n-2).
struct FilterSection {
  double b0, b1, b2, a1, a2;

  void run(std::vector<double>& samples) const {
    double z1 = 0.0, z2 = 0.0;
    for (double& x : samples) {
      const double y = b0 * x + z1;
      z1 = b1 * x - a1 * y + z2;
      z2 = b2 * x - a2 * y;
      x = y;
    }
  }
};

enum class Pass { low, high };

/// The Butterworth polynomial is the product of s^2 + 2 sin((2k-1) pi / 2n) s + 1, k = 1 ... n/2,
/// and s + 1 where n is odd; s = (1 - 1/z) / (1 + 1/z) / w of a low-pass, the inverse of a
/// high-pass, with w = tan(pi f dt), which puts the corner at f.
std::vector<FilterSection> sections(Pass pass, double corner_hz, double dt_s, int order) {
  const double w = std::tan(std::numbers::pi * corner_hz * dt_s);
  std::vector<FilterSection> all;
  for (int k = 1; k <= order / 2; ++k) {
    const double damping = 2.0 * std::sin((2 * k - 1) * std::numbers::pi / (2.0 * order)) * w;
    const double whole = 1.0 + damping + w * w;
    const double b0 = (pass == Pass::low ? w * w : 1.0) / whole;
    all.push_back({b0, pass == Pass::low ? 2.0 * b0 : -2.0 * b0, b0, 2.0 * (w * w - 1.0) / whole,
                   (1.0 - damping + w * w) / whole});
  }
  if (order % 2 == 1) {
    const double b0 = (pass == Pass::low ? w : 1.0) / (1.0 + w);
    all.push_back({b0, pass == Pass::low ? b0 : -b0, 0.0, (w - 1.0) / (1.0 + w), 0.0});
  }
  return all;
}

}  // namespace

std::vector<double> band_passed(std::span<const double> samples, double dt_s,
                                const ButterworthBand& band) {
  std::vector<double> a(samples.begin(), samples.end());
  for (const auto& [corner_hz, pass] :
       {std::pair{band.low_hz, Pass::high}, std::pair{band.high_hz, Pass::low}}) {
    if (!corner_hz) continue;
    GLISSADE_EXPECTS(*corner_hz > 0.0 && *corner_hz * dt_s < 0.5 && band.order >= 1);
    const std::vector<FilterSection> filter = sections(pass, *corner_hz, dt_s, band.order);
    for (int direction = 0; direction < 2; ++direction) {
      for (const FilterSection& section : filter) section.run(a);
      std::ranges::reverse(a);
    }
  }
  return a;
}

}  // namespace glissade
