// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "glissade/block/slide.hpp"
#include "glissade/building/roof_motion.hpp"

namespace glissade::test {

/// One horizontal component of a motion, with the vertical of its record.
struct Component {
  std::string id;  ///< "synthetic_level2/level2_1/first"
  double dt_s = 0.0;
  std::vector<double> horizontal_mps2;
  std::vector<double> vertical_mps2;  ///< empty: the record has none
  double pga_mps2 = 0.0;              ///< of the horizontal
};

/// One history: a component scaled to a peak ground acceleration, a building (5 % damping; the
/// vertical reaches the roof unchanged), a block.
struct StandardScene {
  std::size_t component = 0;
  double period_s = 0.0;  ///< 0: rigid
  double pga_g = 0.0;
  Block block;
  bool vertical = false;  ///< with the record's vertical, by the same factor

  double factor(const std::vector<Component>& components) const;  ///< on the motion
  /// "synthetic_level2/level2_1/first, T 0.5 s, PGA 1 g, mu 0.3, slope -4 deg, vertical".
  std::string describe(const std::vector<Component>& components) const;
  /// The part of a roof motion made of roof_input() that acts on the block; a free slider's ends
  /// with the record.
  RoofAcceleration excitation(const std::vector<Component>& components,
                              const RoofMotion& roof) const;
};

/// The scenes that schemes are timed and judged on, the same wherever the records are: PGA 0.2,
/// 0.5, 1 and 1.5 g; rigid and periods of 0.2, 0.5 and 1 s; friction 0.1, 0.3, 0.5 and 0.7; slopes
/// 0, 1.19, 4 and 7 degrees, both ways; without and, where the record has one, with the vertical.
/// Friction 0.1 on 7 degrees slides freely.
struct StandardScenes {
  std::vector<Component> components;
  std::vector<StandardScene> scenes;  ///< those on one roof motion are neighbours
  std::string motions;                ///< a sentence on which motions these are
};

/// All horizontal components of the built-in Level 2 suite and, where they are found (in
/// $GLISSADE_RECORDS, else in `recorded`), of the recorded suites: Walters et al. (2012) Table 3
/// and the FEMA P-695 far-field set.
StandardScenes standard_scenes(const std::filesystem::path& suites,
                               const std::filesystem::path& recorded);
/// Those of the built-in suite only, on the first `components` of its 14.
StandardScenes built_in_scenes(const std::filesystem::path& suites, std::size_t components = 14);

/// The stride through so many standard scenes that takes about `count` of them: without a factor in
/// common with the number of scenes or of any parameter's values, so that every value comes up with
/// every other. Always the same.
std::size_t thinning(std::size_t scenes, std::size_t count);

/// What makes the roof motion that serves all scenes of a component and a period.
struct RoofInput {
  GroundMotion ground;
  Building building;
  RoofMotionOptions follow;
};
RoofInput roof_input(const Component& component, double period_s);

/// Calls visit(roof, the scenes on it) for each roof motion, one at a time.
void for_each_roof(
    const std::vector<Component>& components, std::span<const StandardScene> scenes,
    const std::function<void(const RoofInput&, std::span<const StandardScene>)>& visit);

}  // namespace glissade::test
