// SPDX-License-Identifier: GPL-3.0-or-later
#include "standard_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>

#include "glissade/io/suite_file.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/study/run/scene.hpp"

namespace glissade::test {
namespace {

constexpr std::array pgas_g{0.2, 0.5, 1.0, 1.5};
constexpr std::array periods_s{0.0, 0.2, 0.5, 1.0};
constexpr std::array frictions{0.1, 0.3, 0.5, 0.7};
constexpr std::array slopes_deg{0.0, 1.19, -1.19, 4.0, -4.0, 7.0, -7.0};

/// For schemes that walk through samples: finer than records are, so that what the straight line
/// between samples leaves (0.1 % of slip) is below what their steps do.
constexpr int samples_per_period = 100;

std::vector<Block> blocks() {
  std::vector<Block> all;
  for (const double friction : frictions)
    for (const double slope_deg : slopes_deg)
      all.push_back({.friction = friction, .slope_rad = slope_deg * rad_per_deg});
  return all;
}

void add_components(const std::filesystem::path& suite_file, std::vector<Component>& components) {
  const Suite suite = load_suite(suite_file);
  for (const Motion& motion : suite.motions) {
    for (const std::size_t i : {0, 1}) {
      const Samples& horizontal = motion.horizontal_mps2[i];
      if (horizontal.empty()) continue;
      components.push_back({suite.name + "/" + motion.id + (i == 0 ? "/first" : "/second"),
                            motion.dt_s, horizontal.copy(), motion.vertical_mps2.copy(),
                            peak_ground_acceleration_mps2(horizontal)});
    }
  }
}

std::vector<StandardScene> scenes_of(const std::vector<Component>& components) {
  std::vector<StandardScene> scenes;
  for (std::size_t i = 0; i < components.size(); ++i)
    for (const double period_s : periods_s)
      for (const double pga_g : pgas_g)
        for (const Block& block : blocks())
          for (const bool vertical : {false, true})
            if (!vertical || !components[i].vertical_mps2.empty())
              scenes.push_back({i, period_s, pga_g, block, vertical});
  return scenes;
}

}  // namespace

double StandardScene::factor(const std::vector<Component>& components) const {
  return pga_g * standard_gravity_mps2 / components[component].pga_mps2;
}

std::string StandardScene::describe(const std::vector<Component>& components) const {
  return fmt::format("{}, T {} s, PGA {} g, mu {}, slope {:.4g} deg{}", components[component].id,
                     period_s, pga_g, block.friction.along, block.slope_rad / rad_per_deg,
                     vertical ? ", vertical" : "");
}

RoofAcceleration StandardScene::excitation(const std::vector<Component>& components,
                                           const RoofMotion& roof) const {
  const bool slides_freely = resting_deceleration_mps2(block) == 0.0;
  const auto part = [&](std::span<const double> samples) {
    return slides_freely ? samples.first(roof.record_samples) : samples;
  };
  RoofAcceleration acceleration{.dt_s = roof.dt_s,
                                .horizontal_mps2 = part(roof.horizontal_mps2),
                                .horizontal_factor = factor(components),
                                .vertical_factor = factor(components)};
  if (vertical) acceleration.vertical_mps2 = part(roof.vertical_mps2);
  return acceleration;
}

StandardScenes built_in_scenes(const std::filesystem::path& suites, std::size_t components) {
  StandardScenes all;
  add_components(suites / "synthetic_level2.toml", all.components);
  all.components.resize(std::min(components, all.components.size()));
  all.scenes = scenes_of(all.components);
  all.motions = std::to_string(all.components.size()) +
                " components of the built-in Level 2 suite, no recorded motions";
  return all;
}

StandardScenes standard_scenes(const std::filesystem::path& suites,
                               const std::filesystem::path& recorded) {
  if (std::getenv("GLISSADE_RECORDS") == nullptr) {
    if (!std::filesystem::is_directory(recorded)) {
      StandardScenes built_in = built_in_scenes(suites);
      built_in.motions += " (none in " + recorded.string() + "; or set GLISSADE_RECORDS)";
      return built_in;
    }
    ::setenv("GLISSADE_RECORDS", recorded.c_str(), 1);
  }
  StandardScenes all;
  for (const char* suite :
       {"synthetic_level2.toml", "walters_table3.toml", "fema_p695_far_field.toml"})
    add_components(suites / suite, all.components);
  all.scenes = scenes_of(all.components);
  all.motions = std::to_string(all.components.size()) +
                " components: the built-in Level 2 suite, Walters et al. (2012) Table 3, FEMA "
                "P-695 far field";
  return all;
}

std::size_t thinning(std::size_t scenes, std::size_t count) {
  std::size_t stride = std::max<std::size_t>(scenes / count, 1);
  // 2 and 7: of the numbers of values of the parameters.
  while (std::gcd(stride, 14 * scenes) != 1) ++stride;
  return stride;
}

RoofInput roof_input(const Component& component, double period_s) {
  const double largest_factor = pgas_g.back() * standard_gravity_mps2 / component.pga_mps2;
  RoofInput input{{component.dt_s, component.horizontal_mps2, component.vertical_mps2},
                  {.horizontal = {period_s, 0.05}},
                  follow_roof(blocks(), largest_factor)};
  input.follow.steps_per_period = samples_per_period;
  return input;
}

void for_each_roof(
    const std::vector<Component>& components, std::span<const StandardScene> scenes,
    const std::function<void(const RoofInput&, std::span<const StandardScene>)>& visit) {
  for (auto first = scenes.begin(); first != scenes.end();) {
    const auto last = std::find_if(first, scenes.end(), [&](const StandardScene& scene) {
      return scene.component != first->component || scene.period_s != first->period_s;
    });
    visit(roof_input(components[first->component], first->period_s), {first, last});
    first = last;
  }
}

}  // namespace glissade::test
