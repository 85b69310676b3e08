// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "unit/block/solvers.hpp"

// How an answer must change, or not, when the question is changed: true of the equations, so that
// no expected number is needed (theory.md, 1.7). For every solver of solvers.hpp.
namespace glissade::test {

/// A motion that begins at zero, so that zeros in front of it change nothing.
struct Scene {
  std::string name;
  double dt_s = 0.0;
  std::vector<double> a, w = {};
  Block block = {};
  RoofAcceleration roof(double factor = 1.0) const { return {dt_s, a, w, factor, factor}; }
};

inline void expect_times(const SlipPeak& actual, const SlipPeak& expected, double factor,
                         double tolerance_m) {
  const auto expect_near = [&](double value, double reference) {
    if (tolerance_m == 0.0) {
      EXPECT_EQ(value, factor * reference);
    } else {
      EXPECT_NEAR(value, factor * reference, tolerance_m);
    }
  };
  expect_near(actual.peak_displacement_m, expected.peak_displacement_m);
  expect_near(actual.residual.along_m, expected.residual.along_m);
  expect_near(actual.peak_downslope_m, expected.peak_downslope_m);
  expect_near(actual.peak_upslope_m, expected.peak_upslope_m);
  EXPECT_EQ(actual.uplift, expected.uplift);
  EXPECT_EQ(actual.free_sliding, expected.free_sliding);
}

/// Rounded otherwise, an answer may differ by `relative` of itself, and by what an acceleration off
/// by its rounding for as long as the block slides gives: that matters where slip is tiny.
inline double rounding_m(const Scene& scene, const SlipPeak& r, double relative) {
  double peak_mps2 = scene.block.gravity_mps2;
  for (const double x : scene.a) peak_mps2 = std::max(peak_mps2, std::abs(x));
  return relative * r.peak_displacement_m +
         std::numeric_limits<double>::epsilon() * peak_mps2 * r.slip_duration_s * r.slip_duration_s;
}

/// a, w and g times lambda: slip times lambda.
inline void expect_similitude(const Scene& scene, const Solver& solver) {
  const SlipPeak one = solver.solve(scene.roof(), scene.block);
  for (const double lambda : {0.125, 64.0, 1.7, 0.3}) {
    Scene scaled = scene;
    scaled.block.gravity_mps2 *= lambda;
    const bool is_exact = std::exp2(std::round(std::log2(lambda))) == lambda;
    expect_times(solver.solve(scene.roof(lambda), scaled.block), one, lambda,
                 is_exact ? 0.0 : lambda * rounding_m(scene, one, 1e-13));
  }
}

inline void expect_mirror(const Scene& scene, const Solver& solver) {
  const SlipPeak one = solver.solve(scene.roof(), scene.block);
  Scene mirrored = scene;
  for (double& x : mirrored.a) x = -x;
  if (scene.block.slope_rad != 0.0) {
    mirrored.block.slope_rad *= -1;  // "down" turns around with the slope
    expect_times(solver.solve(mirrored.roof(), mirrored.block), one, 1.0, 0.0);
  } else {
    const SlipPeak other = solver.solve(mirrored.roof(), mirrored.block);
    EXPECT_EQ(other.residual.along_m, -one.residual.along_m);
    EXPECT_EQ(other.peak_downslope_m, one.peak_upslope_m);
    EXPECT_EQ(other.peak_upslope_m, one.peak_downslope_m);
  }
}

/// Samples on the straight lines between samples, `parts` to an interval.
inline std::vector<double> refined(const std::vector<double>& x, int parts) {
  std::vector<double> y;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double next = i + 1 < x.size() ? x[i + 1] : 0.0;
    for (int k = 0; k < parts; ++k) y.push_back(std::lerp(x[i], next, double(k) / parts));
  }
  return y;
}

inline void expect_inserted_samples_change_nothing(const Scene& scene, const Solver& solver) {
  if (std::tan(std::abs(scene.block.slope_rad)) > scene.block.friction.along)
    return;  // ends elsewhere
  const SlipPeak one = solver.solve(scene.roof(), scene.block);
  for (const int parts : {2, 3}) {
    Scene fine = scene;
    fine.a = refined(scene.a, parts);
    fine.w = refined(scene.w, parts);
    fine.dt_s /= parts;
    expect_times(solver.solve(fine.roof(), scene.block), one, 1.0, rounding_m(scene, one, 1e-12));
  }
}

inline void expect_padding_and_shift_change_nothing(const Scene& scene, const Solver& solver) {
  if (std::tan(std::abs(scene.block.slope_rad)) > scene.block.friction.along)
    return;  // never at rest
  const SlipPeak one = solver.solve(scene.roof(), scene.block);
  const auto with_zeros = [](const std::vector<double>& x, std::size_t before, std::size_t after) {
    if (x.empty()) return x;
    std::vector<double> y(before, 0.0);
    y.insert(y.end(), x.begin(), x.end());
    y.resize(y.size() + after, 0.0);
    return y;
  };
  for (const auto& [before, after] : {std::pair{0, 777}, std::pair{1, 0}, std::pair{1000, 3}}) {
    Scene moved = scene;
    moved.a = with_zeros(scene.a, before, after);
    moved.w = with_zeros(scene.w, before, after);
    const SlipPeak r = solver.solve(moved.roof(), scene.block);
    expect_times(r, one, 1.0, 0.0);
    EXPECT_EQ(r.slip_phases, one.slip_phases);
    EXPECT_EQ(r.slip_duration_s, one.slip_duration_s);
  }
}

/// Equal samples, another clock: slip times the square of the steps' ratio.
inline void expect_clock_scaling(const Scene& scene, const Solver& solver) {
  const SlipPeak one = solver.solve(scene.roof(), scene.block);
  for (const double ratio : {2.0, 0.25, 3.0}) {
    Scene slower = scene;
    slower.dt_s *= ratio;
    expect_times(solver.solve(slower.roof(), scene.block), one, ratio * ratio,
                 ratio == 3.0 ? 9 * rounding_m(scene, one, 1e-13) : 0.0);
  }
}

/// Held from going up, the block's velocity is never below that of the block that may: they obey
/// one equation while both go down, and the first is never negative. So its displacement is never
/// smaller, on any slope; upslope it does not go. What does not follow is that its peak is larger:
/// the other's may lie upslope. On a flat roof that is the downslope of the mirrored motion.
inline void expect_one_way_beyond_two_way(const Scene& scene, const Solver& solver) {
  Block one_way = scene.block;
  one_way.directions = SlipDirections::downslope_only;
  const SlipPeak both = solver.solve(scene.roof(), scene.block),
                 one = solver.solve(scene.roof(), one_way);
  const double tolerance_m = rounding_m(scene, both, 1e-12);
  EXPECT_EQ(one.peak_upslope_m, 0.0);
  EXPECT_GE(one.peak_downslope_m + tolerance_m, both.peak_downslope_m);
  EXPECT_GE(one.residual.along_m + tolerance_m, both.residual.along_m);
  if (scene.block.slope_rad != 0.0) return;
  Scene mirrored = scene;
  for (double& x : mirrored.a) x = -x;
  const SlipPeak other = solver.solve(mirrored.roof(), one_way);
  EXPECT_GE(std::max(one.peak_displacement_m, other.peak_displacement_m) + tolerance_m,
            both.peak_displacement_m);
}

/// Runs a relation over scenes and solvers; returns how many scenes slipped.
template <class Relation>
int over(const std::vector<Scene>& scenes, const Relation& relation) {
  int slipped = 0;
  for (const Scene& scene : scenes) {
    slipped += slide(scene.roof(), scene.block).slip_phases > 0 ? 1 : 0;
    for (const Solver& solver : solvers()) {
      SCOPED_TRACE(scene.name + ", " + solver.name);
      relation(scene, solver);
    }
  }
  return slipped;
}

}  // namespace glissade::test
