// SPDX-License-Identifier: GPL-3.0-or-later
// The full model where it must come back to the simpler ones.
#include "glissade/block/on_building.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>
#include <random>

#include "glissade/block/coupled.hpp"
#include "unit/block/on_building_scene.hpp"

namespace glissade {
namespace {

using test::made_up_record;
using test::OnBuilding;

double relative(double found, double expected, double scale) {
  return std::abs(found - expected) / scale;
}

double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
}

/// Largest difference from slide_coupled(), relative to what it peaks at.
double difference(const BuildingSlip& two, const CoupledResult& one) {
  const double slip = std::max(one.slip.peak_displacement_m, 1e-12);
  return std::max({relative(two.slip.peak_displacement_m, one.slip.peak_displacement_m, slip),
                   relative(two.slip.residual.along_m, one.slip.residual_displacement_m, slip),
                   relative(two.slip.residual.across_m, 0.0, slip),
                   relative(two.peak_base_shear[0], one.peak_base_shear, one.peak_base_shear),
                   relative(two.peak_roof_displacement_m[0], one.peak_roof_displacement_m,
                            std::max(one.peak_roof_displacement_m, 1e-12))});
}

TEST(explore, stress) {
  std::mt19937 random(11);
  int bad = 0; double slowest = 0; 
  for (unsigned k = 0; k < 3000; ++k) {
      OnBuilding scene(random, k, 150);
      for (Oscillator& o : scene.building.horizontal) { o.period_s = std::exp(uniform(random, std::log(0.05), std::log(5.0))); if (random() % 5 == 0) o.period_s = 0; if (random() % 7 == 0) o.damping_ratio = 0; if (random() % 31 == 0) o.damping_ratio = 1.5;}
      const double mu = std::exp(uniform(random, std::log(0.05), std::log(2.0)));
      scene.block.friction = {mu, random() % 2 ? mu : mu * uniform(random, 0.5, 1.5)};
      scene.building.mass_ratio = random() % 3 == 0 ? 0.0 : uniform(random, 0, 1);
      const auto which = random() % 6;
      scene.block.slope_rad = which == 0 ? 0 : which == 1 ? std::atan(mu) : which == 2 ? std::atan(mu) + 0.01 : uniform(random, 0, std::atan(mu));
      if (random() % 4 == 0) scene.building.yielding = {Yielding{uniform(random, 0.5, 4), random() % 2 ? 0.0 : 0.1}, Yielding{uniform(random, 0.5, 4), 0.03}};
      if (random() % 4 == 0) scene.block.law.static_ratio = uniform(random, 1, 2);
      if (random() % 4 == 0) { scene.block.law.fast_ratio = uniform(random, 0.5, 2); scene.block.law.rate_spm = uniform(random, 1, 200); }
      if (random() % 3 == 0) for (double& w : scene.up) w *= 4.0;
      if (random() % 3 == 0) scene.vertical = {uniform(random, 0.05, 0.5), 0.05};
      scene.tolerance = std::exp(uniform(random, std::log(1e-9), std::log(1e-2)));
      if (!coupling_is_regular(scene.block, scene.building)) { ++bad; continue; }
      const auto t0 = std::chrono::steady_clock::now();
      try {
      const BuildingSlip r = scene.result();
      if (!std::isfinite(r.slip.peak_displacement_m + r.slip.path_length_m + r.peak_base_shear[0] + r.peak_base_shear[1] + r.peak_roof_displacement_m[0])) printf("nan %u\n", k);
      } catch (std::exception& e) { printf("%u T %.3f %.3f r %.3f slope %.3f mu %.3f %.3f tol %g static %g fast %g rate %g yields %d zeta %g %g %s\n", k, scene.building.horizontal[0].period_s,scene.building.horizontal[1].period_s, scene.building.mass_ratio, scene.block.slope_rad, scene.block.friction.along,scene.block.friction.across,scene.tolerance,scene.block.law.static_ratio,scene.block.law.fast_ratio,scene.block.law.rate_spm,scene.building.yielding[0].yields(), scene.building.horizontal[0].damping_ratio,scene.building.horizontal[1].damping_ratio, e.what()); }
      const double s = std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count();
      if (s > 0.05) printf("%u took %.3f T %.3f %.3f r %.3f slope %.3f mu %.3f %.3f tol %g static %g fast %g rate %g yields %d zeta %g %g free %d\n", k, s, scene.building.horizontal[0].period_s,scene.building.horizontal[1].period_s, scene.building.mass_ratio, scene.block.slope_rad, scene.block.friction.along,scene.block.friction.across,scene.tolerance,scene.block.law.static_ratio,scene.block.law.fast_ratio,scene.block.law.rate_spm,scene.building.yielding[0].yields(), scene.building.horizontal[0].damping_ratio,scene.building.horizontal[1].damping_ratio,0);
      slowest = std::max(slowest, s);
  }
  printf("irregular %d slowest %.3f s\n", bad, slowest);
}

TEST(slide_on_building, is_slide_coupled_where_the_ground_moves_along_the_slope) {
  std::mt19937 random(3);
  std::vector<double> errors;
  for (unsigned k = 0; k < 60; ++k) {
    OnBuilding scene(random, k, 600);
    scene.second.clear();
    scene.block.azimuth_rad = k % 3 == 0 ? std::numbers::pi : 0.0;
    scene.building.horizontal[1].period_s = k % 2 == 0 ? 0.0 : 0.7;
    scene.tolerance = 1e-7;
    if (k % 5 == 0) scene.building.mass_ratio = 0.0;
    const double towards = k % 3 == 0 ? -1.0 : 1.0;
    const BuildingSlip two = scene.result();
    const CoupledResult one = slide_coupled(
        {scene.dt_s, scene.first, scene.up}, {scene.factor, scene.factor},
        {scene.building.horizontal[0], scene.building.mass_ratio},
        {.friction = scene.block.friction.along, .slope_rad = towards * scene.block.slope_rad});
    if (one.slip.slip_phases == 0) continue;
    const double e = difference(two, one);
    errors.push_back(e);
    if (e > 1e-6)
      printf(
          "%u T %.3f r %.3f slope %.3f mu %.3f: %.3e | %.6g %.6g | %.6g %.6g | %.8g %.8g | %.8g "
          "%.8g| %zu %zu %d %d\n",
          k, scene.building.horizontal[0].period_s, scene.building.mass_ratio,
          scene.block.slope_rad, scene.block.friction.along, e, two.slip.peak_displacement_m,
          one.slip.peak_displacement_m, two.slip.residual.along_m, one.slip.residual_displacement_m,
          two.peak_base_shear[0], one.peak_base_shear, two.peak_roof_displacement_m[0],
          one.peak_roof_displacement_m, two.slip.slip_phases, one.slip.slip_phases, two.slip.uplift,
          one.slip.uplift);
  }
  std::sort(errors.begin(), errors.end());
  printf("%zu median %.3e max %.3e\n", errors.size(), errors[errors.size() / 2], errors.back());
}

}  // namespace
}  // namespace glissade
