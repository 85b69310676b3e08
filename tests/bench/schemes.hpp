// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "glissade/block/slide.hpp"
#include "standard_scenes.hpp"

namespace glissade::bench {

/// One history as a scheme gets it.
struct History {
  Block block;
  double factor = 1.0;  ///< on the roof's motion, both components
  bool vertical = false;
  RoofAcceleration
      excitation;  ///< the samples of the roof motion that act on the block, and the factor
};

/// Peak displacement of a history, in plan, m.
using PeakScheme = std::function<double(const History&)>;

/// The roof of some histories: what it is made of, and its samples.
struct Roof {
  test::RoofInput input;
  RoofMotion motion;
};

/// What a scheme's peaks are judged against.
enum class Problem {
  samples,          ///< the roof's acceleration is linear between the samples of its motion
  one_way_samples,  ///< and the block slides downslope only
  oscillator,       ///< the roof is an oscillator whose motion is known at all times
  none              ///< it is no scheme
};

/// A way to get the peak. What serves all histories on one roof (tables) is made by `on_roof`, and
/// is not in the time of a history.
struct Scheme {
  std::string family;  ///< a curve of the figure
  std::string label;   ///< its point: "P = 64"
  std::function<PeakScheme(const Roof&)> on_roof;
  Problem problem = Problem::samples;
  bool exact = false;  ///< no step to choose: timed on all standard scenes
};

/// The floor for any scheme, one pass over the samples for their largest |acceleration|; then every
/// scheme. The only place that names them.
/// @param quick only a few substeps each, for the smoke test
std::vector<Scheme> schemes(bool quick);

}  // namespace glissade::bench
