// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "closed_forms/oscillator.hpp"
#include "closed_forms/sine.hpp"
#include "glissade/building/roof_motion.hpp"
#include "unit/block/solvers.hpp"

/// What the code that is tested gives, in the terms of the closed forms.
namespace glissade::closed_forms {

/// From which side alpha comes first.
enum class Against {
  down,  ///< the roof accelerates toward -x, and the block is left behind downslope
  up
};

struct Sampled {
  double dt_s;
  std::vector<double> alpha;
};

inline SlipPeak under(const Sampled& motion, Against against, const Block& block,
                      const test::Solver& solver) {
  return solver.solve({.dt_s = motion.dt_s,
                       .horizontal_mps2 = motion.alpha,
                       .horizontal_factor = against == Against::down ? -1.0 : 1.0},
                      block);
}

/// A block under a harmonic, with the vertical in proportion to the horizontal.
struct Shaken {
  Harmonic motion;
  Block block;
  double vertical_ratio = 0.0;

  Slider sliding() const { return slider(block, vertical_ratio); }
  SteadyState steady() const { return steady_state(motion, sliding()); }

  /// After so many half cycles of so many parts a cycle.
  SlipPeak after(const test::Solver& solver, int half_cycles, int parts) const {
    const std::vector<double> alpha = motion.alpha(parts, half_cycles);
    RoofAcceleration roof{
        .dt_s = motion.period_s / parts, .horizontal_mps2 = alpha, .horizontal_factor = -1.0};
    if (vertical_ratio != 0.0) {
      roof.vertical_mps2 = alpha;
      roof.vertical_factor = -vertical_ratio;
    }
    return solver.solve(roof, block);
  }

  /// Of one cycle, when the start is forgotten; the end of the record is the same for both.
  double drift_m(const test::Solver& solver, int parts) const {
    return (after(solver, 160, parts).residual.along_m -
            after(solver, 140, parts).residual.along_m) /
           10;
  }
  double sliding_s(const test::Solver& solver, int parts) const {
    return (after(solver, 160, parts).slip_duration_s - after(solver, 140, parts).slip_duration_s) /
           10;
  }
};

/// Roof per ground acceleration, from the last of 400 cycles sampled n times each: by then the
/// start has gone to exp(-800 pi damping / ratio).
inline std::complex<double> transmission_of_roof(double ratio, double damping, int n) {
  std::vector<double> ground;
  for (int i = 0; i <= 400 * n; ++i) ground.push_back(std::sin(2 * std::numbers::pi * (i % n) / n));
  const double dt = 0.01;  // ratio = oscillator's period / ground's period
  const RoofMotion roof = roof_motion({dt, ground}, {.horizontal = {ratio * n * dt, damping}}, {});
  const auto parts = static_cast<std::size_t>(std::lround(dt / roof.dt_s));
  std::vector<double> cycle;
  for (std::size_t i = ground.size() - 1 - static_cast<std::size_t>(n); i + 1 < ground.size(); ++i)
    cycle.push_back(roof.horizontal_mps2[i * parts]);
  return amplitude(cycle);
}

}  // namespace glissade::closed_forms
