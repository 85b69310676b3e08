// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/simulation/synthetic_suite.hpp"

#include <fmt/format.h>

#include "glissade/core/in_parallel.hpp"
#include "glissade/motion/simulation/bssa14.hpp"
#include "glissade/motion/simulation/components.hpp"

namespace glissade {

Scenario scenario_of(const SyntheticMotion& motion) {
  return {motion.magnitude, motion.distance_km, motion.vs30_mps, motion.mechanism};
}

SuiteGain gain_of(const SyntheticRecipe& recipe) {
  return {{recipe.gain_frequencies_hz, recipe.horizontal_gain},
          {recipe.gain_frequencies_hz, recipe.vertical_gain}};
}

Motion simulate_motion(const SyntheticRecipe& recipe, const SyntheticMotion& source) {
  const RealizationKey key{recipe.seed, source.realization};
  auto [dt_s, components] =
      shape_motion(simulate_raw_motion(scenario_of(source), key, recipe.dt_s), gain_of(recipe));
  Motion motion;
  motion.id = source.id;
  motion.event = fmt::format("simulated {}/{}", recipe.seed, source.realization);
  motion.station = source.id;
  motion.magnitude = source.magnitude;
  motion.distance_km = source.distance_km;
  motion.vs30_mps = source.vs30_mps;
  motion.scale = source.scale;
  motion.dt_s = dt_s;
  motion.horizontal_mps2 = {std::move(components[0]), std::move(components[1])};
  motion.vertical_mps2 = std::move(components[2]);
  motion.contradictions = outside_bssa14(scenario_of(source));
  return motion;
}

Suite simulate_suite(const SyntheticRecipe& recipe) {
  Suite suite{.name = recipe.name,
              .description = recipe.description,
              .motions = {},
              .target = recipe.target,
              .nearest_to_target = recipe.nearest_to_target};
  suite.motions.resize(recipe.motions.size());
  in_parallel(recipe.motions.size(), [&](std::size_t i) {
    suite.motions[i] = simulate_motion(recipe, recipe.motions[i]);
  });
  return suite;
}

}  // namespace glissade
