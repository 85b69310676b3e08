// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <span>
#include <vector>

#include "glissade/block/two_axis_lanes.hpp"
#include "unit/block/on_building_scene.hpp"

// Scenes of the two-axis kernel, of every model.
namespace glissade::test::lanes {

enum class Kind { rigid, uncoupled, modes, coupled, coupled_modes, yielding };
constexpr Kind all_kinds[] = {Kind::rigid,   Kind::uncoupled,     Kind::modes,
                              Kind::coupled, Kind::coupled_modes, Kind::yielding};

/// Two to six modes, or one that is not one mass, of 0.05 s and longer.
inline Modes cantilever(double period_s, double alpha, std::size_t count = most_modes) {
  return Modes(governing_modes(cantilever_modes(period_s, alpha, count)));
}

inline BuildingGround ground_of(unsigned seed) {
  OnBuilding scene(seed, 900, 6.0);
  scene.dt_s = 0.01;
  return scene.ground();
}

inline std::vector<TwoAxisScene> made_up_scenes(Kind kind, std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<TwoAxisScene> scenes(count);
  for (std::size_t k = 0; k < count; ++k) {
    TwoAxisScene& s = scenes[k];
    if (kind != Kind::rigid)
      for (Modes& o : s.building.horizontal)
        o = {0.2 + 0.3 * static_cast<double>(k / 4 % 4), 0.05};  // four on each building
    if (kind == Kind::modes || kind == Kind::coupled_modes) {
      const double period_s = s.building.horizontal[0].period_s();
      s.building.horizontal = {cantilever(period_s, 2.0), cantilever(0.8 * period_s, 10.0)};
    }
    if (kind == Kind::coupled || kind == Kind::coupled_modes || kind == Kind::yielding)
      s.building.mass_ratio = 0.02 + 0.04 * static_cast<double>(k / 4 % 3);
    if (kind == Kind::yielding) {
      if (k % 5 == 0) s.building.mass_ratio = 0.0;
      s.building.yielding[0] = {uniform(random, 1.0, 6.0), k % 3 == 0 ? 0.0 : 0.05};
      if (k % 4 != 0) s.building.yielding[1] = {uniform(random, 1.0, 6.0), 0.02};
    }
    const double mu = uniform(random, 0.05, 0.6);
    s.block.friction = {mu, k % 3 == 0 ? mu : uniform(random, 0.6, 1.6) * mu};
    s.block.slope_rad = uniform(random, 0.0, 0.9) * std::min(std::atan(mu), 0.2);
    s.block.azimuth_rad = uniform(random, -3.0, 3.0);
    const double factor = std::exp(uniform(random, std::log(0.2), std::log(2.0)));
    s.factors = {{random() % 2 == 0 ? factor : -factor, factor}, factor};
    s.base_shear = kind != Kind::modes && kind != Kind::coupled_modes;
  }
  return scenes;
}

inline std::vector<BuildingPeak> solve(const BuildingGround& ground,
                                       std::span<const TwoAxisScene> scenes,
                                       double tolerance = 1e-6) {
  std::vector<BuildingPeak> peaks(scenes.size());
  peak_slip_two_axes(ground, scenes, peaks, tolerance);
  return peaks;
}

inline std::vector<TwoAxisScene> with_static_friction(std::vector<TwoAxisScene> scenes) {
  for (std::size_t k = 0; k < scenes.size(); ++k)
    scenes[k].block.law.static_over_sliding = 1.02 + 0.1 * static_cast<double>(k % 7);
  return scenes;
}

/// Rising with speed and falling.
inline std::vector<TwoAxisScene> with_friction_by_speed(std::vector<TwoAxisScene> scenes) {
  constexpr double fast_over_slow[] = {1.5, 0.8, 1.2, 2.0, 0.6}, rate_s_per_m[] = {5.0, 20.0, 60.0};
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    FrictionLaw& law = scenes[k].block.law;
    law.fast_over_slow = fast_over_slow[k % 5];
    law.rate_s_per_m = rate_s_per_m[k % 3];
    if (k % 4 == 0) law.static_over_sliding = 1.1;
    scenes[k].block.slope_rad *= 0.5;  // so that the least friction stops the block
  }
  return scenes;
}

/// Of every model that a kind of roof can have.
inline std::vector<TwoAxisScene> scenes_of_all_models(Kind kind, std::size_t count, unsigned seed) {
  std::vector<TwoAxisScene> all = made_up_scenes(kind, count, seed);
  for (const TwoAxisScene& s : with_static_friction(made_up_scenes(kind, count, seed + 1)))
    all.push_back(s);
  for (const TwoAxisScene& s : with_friction_by_speed(made_up_scenes(kind, count, seed + 2)))
    all.push_back(s);
  return all;
}

/// Under a vertical that lifts most of them off the roof, again and again.
inline std::vector<TwoAxisScene> lifted_scenes(Kind kind, std::size_t count, unsigned seed) {
  std::vector<TwoAxisScene> scenes = made_up_scenes(kind, count, seed);
  std::mt19937 random(seed + 1);
  for (TwoAxisScene& s : scenes) s.factors.vertical *= uniform(random, 1.0, 8.0);
  return scenes;
}

inline std::vector<double> numbers(std::span<const BuildingPeak> peaks) {
  std::vector<double> all;
  for (const BuildingPeak& p : peaks)
    all.insert(all.end(), {p.peak_displacement_m, p.peak_by_axis.along_m, p.peak_by_axis.across_m,
                           p.peak_downslope_m, p.peak_upslope_m, p.residual.along_m,
                           p.residual.across_m, static_cast<double>(p.slip_phases),
                           p.uplift ? 1.0 : 0.0, p.base_shear[0], p.base_shear[1]});
  return all;
}

}  // namespace glissade::test::lanes
