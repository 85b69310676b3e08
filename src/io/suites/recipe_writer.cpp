// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/recipe_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "toml/toml_text.hpp"

namespace glissade {
namespace {

std::string numbers(const std::vector<double>& values) {
  return fmt::format("[{}]", fmt::join(values, ", "));
}

std::string motion_toml(const SyntheticMotion& motion) {
  return fmt::format(
      "\n[[motion]]\n"
      "id = {}\n"
      "magnitude = {}\n"
      "distance_km = {}\n"
      "vs30_mps = {}\n"
      "mechanism = {}\n"
      "realization = {}\n"
      "scale = {}\n",
      quoted(motion.id), motion.magnitude, motion.distance_km, motion.vs30_mps,
      quoted(motion.mechanism == FaultMechanism::reverse ? "reverse" : "strike_slip"),
      motion.realization, motion.scale);
}

}  // namespace

std::string recipe_toml(const SyntheticRecipe& recipe, const std::vector<std::string>& comments) {
  std::string text = fmt::format(
      "# {}\n"
      "# Motions simulated by the stochastic model of Rezaeian & Der Kiureghian (2010); the gain "
      "towards the BSSA14\n"
      "# median spectra is ours, not published. See README.md in this folder.\n"
      "\n"
      "[suite]\n"
      "name = {}\n"
      "description = {}\n"
      "{}\n"
      "{}\n"
      "[simulation]\n"
      "model = \"rezaeian_der_kiureghian_2010\"\n"
      "seed = {}\n"
      "dt_s = {}\n"
      "{}\n"
      "[simulation.gain]\n"
      "frequency_hz = {}\n"
      "horizontal = {}\n"
      "vertical = {}\n",
      fmt::join(comments, "\n# "), quoted(recipe.name), quoted(recipe.description),
      recipe.nearest_to_target ? "selection = \"nearest_to_target\"\n" : "",
      target_toml(recipe.target), recipe.seed, recipe.dt_s,
      // Zero where the recipe does not state it.
      recipe.max_scale > 0.0 ? fmt::format("max_scale = {}\n", recipe.max_scale) : "",
      numbers(recipe.gain_frequencies_hz), numbers(recipe.horizontal_gain),
      numbers(recipe.vertical_gain));
  for (const SyntheticMotion& motion : recipe.motions) text += motion_toml(motion);
  return text;
}

}  // namespace glissade
