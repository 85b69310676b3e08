// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "two_axis_truth/two_axis_truth.hpp"
#include "unit/block/modes_reference.hpp"
#include "unit/block/on_building_scene.hpp"

namespace glissade::test {

enum class Roof { rigid, uncoupled, rigid_across, coupled };
enum class Law {
  circle,
  ellipse,
  static_friction,
  rising_with_speed,
  falling_with_speed,
  rising_steeply,  ///< over 1 mm/s
  all_options,
  rising_at_once  ///< over 0.01 mm/s: not among all_laws
};
constexpr Roof all_roofs[] = {Roof::rigid, Roof::uncoupled, Roof::rigid_across, Roof::coupled};
constexpr Law all_laws[] = {Law::circle,
                            Law::ellipse,
                            Law::static_friction,
                            Law::rising_with_speed,
                            Law::falling_with_speed,
                            Law::rising_steeply,
                            Law::all_options};

/// A scene of rough motions on a building of m/M up to 0.5, with 8 samples a period or more.
inline OnBuilding truth_scene(std::mt19937& random, Roof roof, Law law, std::size_t samples) {
  const auto seed = static_cast<unsigned>(random() % 1000000);
  OnBuilding scene(random, seed, samples);
  for (Modes& o : scene.building.horizontal) o[0].period_s = std::max(o.period_s(), 8 * scene.dt_s);
  if (roof == Roof::rigid) scene.building = {};
  if (roof == Roof::uncoupled) scene.building.mass_ratio = 0.0;
  if (roof == Roof::rigid_across) scene.building.horizontal[1][0].period_s = 0.0;
  if (law == Law::ellipse)
    scene.block.friction.across *= std::uniform_real_distribution<double>(0.6, 1.6)(random);
  if (law == Law::static_friction) scene.block.law.static_over_sliding = 1.3;
  if (law == Law::rising_with_speed) scene.block.law = {1.0, 1.5, 30.0};
  if (law == Law::rising_steeply) scene.block.law = {1.0, 1.5, 1e3};
  if (law == Law::rising_at_once) scene.block.law = {1.0, 1.5, 1e5};
  if (law == Law::all_options) {
    scene.block.friction.across *= 0.8;
    scene.block.law = {1.2, 1.3, 100.0};
  }
  if (law == Law::falling_with_speed) {
    scene.block.law = {1.0, 0.7, 30.0};
    scene.block.slope_rad *= 0.6;
  }
  return scene;
}

inline TruthScene as_truth(const OnBuilding& scene) {
  return {.dt_s = scene.dt_s,
          .ground_mps2 = {scene.first, scene.second},
          .vertical_mps2 = scene.up,
          .factors = {scene.factor, scene.factor},
          .building = scene.building,
          .block = scene.block};
}

/// Three storeys, the lightest floor on top, of a first period near 0.45 s.
inline ShearBuilding three_storeys(double stiffer = 1.0, double damping_ratio = 0.05) {
  return {{1.0, 0.8, 0.5}, {700.0 * stiffer, 500.0 * stiffer, 300.0 * stiffer}, damping_ratio};
}

inline Modes modes_of(const ShearBuilding& building) {
  std::vector<Mode> modes = shear_building_modes(building.masses, building.stiffnesses);
  for (Mode& mode : modes) mode.damping_ratio = building.damping_ratio;
  return Modes(modes);
}

/// A scene on three storeys, along one axis or both, and its truth by full matrices.
struct StoreyScene {
  OnBuilding scene;
  std::array<ShearBuilding, 2> storeys;

  StoreyScene(unsigned seed, double mass_ratio, bool two_axes) : scene(seed, 160, 9.0) {
    scene.dt_s = 0.01;
    scene.building = {};
    scene.building.mass_ratio = mass_ratio;
    storeys[0] = three_storeys();
    if (two_axes) storeys[1] = three_storeys(0.6, 0.03);
    for (std::size_t n = 0; n < (two_axes ? 2u : 1u); ++n)
      scene.building.horizontal[n] = modes_of(storeys[n]);
    if (!two_axes) scene.second.clear();
    if (!two_axes) scene.block.azimuth_rad = 0.0;
  }
  TwoAxisTruth truth() const {
    TruthScene as = as_truth(scene);
    as.storeys = storeys;
    return TwoAxisTruth(as);
  }
};

/// A cantilever of 0.9 s under a block that is heavy for its modes, and a harmonic ground along one
/// axis, with a second of rest after it.
struct StrongCoupling {
  double peak_g, ground_hz, alpha, mass_ratio;

  OnBuilding scene() const {
    OnBuilding s;
    s.dt_s = 0.01;
    s.first.assign(600, 0.0);
    for (int i = 0; i <= 500; ++i)
      s.first[i] = peak_g * standard_gravity_mps2 *
                   std::sin(2.0 * std::numbers::pi * ground_hz * i * s.dt_s);
    s.second.clear();
    s.up.clear();
    std::vector<Mode> modes = governing_modes(cantilever_modes(0.9, alpha, 12));
    for (Mode& mode : modes) mode.damping_ratio = 0.3;
    s.building = {{Modes(modes), Modes(modes)}, {}, mass_ratio};
    s.block = {.friction = 0.2, .slope_rad = rad_per_deg};
    return s;
  }
  ModesReference truth() const {
    const OnBuilding s = scene();
    return {s.first, s.dt_s, s.building.horizontal[0], mass_ratio, s.block, 1.0, 60};
  }
};
/// m/M times the sum of gamma^2 / e: 5.5, 12, 0.9 and 10.
constexpr StrongCoupling strong_couplings[] = {
    {0.3, 2.0, 7.0, 0.3}, {0.8, 1.5, 0.0, 1.0}, {0.3, 2.0, 7.0, 0.05}, {0.5, 3.0, 20.0, 0.6}};

inline std::vector<double> numbers(const BuildingSlip& r) {
  return {r.slip.peak_displacement_m,    r.slip.residual.along_m,
          r.slip.residual.across_m,      r.slip.path_length_m,
          r.slip.peak_velocity_mps,      static_cast<double>(r.slip.slip_phases),
          r.peak_base_shear[0],          r.peak_base_shear[1],
          r.peak_roof_displacement_m[0], r.peak_roof_displacement_m[1]};
}

/// Largest difference in any displacement, relative to the peak; for SlipResult or BuildingPeak.
template <class Result>
double error_of(const Result& r, const TwoAxisTruth& truth) {
  const auto off = [](double x, Long exact) { return std::abs(static_cast<double>(x - exact)); };
  return std::max({off(r.peak_displacement_m, truth.peak_m),
                   off(r.peak_by_axis.along_m, truth.peak_along_m),
                   off(r.peak_by_axis.across_m, truth.peak_across_m),
                   off(r.residual.along_m, truth.along_m),
                   off(r.residual.across_m, truth.across_m)}) /
         static_cast<double>(truth.peak_m);
}

}  // namespace glissade::test
