// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "schemes.hpp"
#include "standard_scenes.hpp"

namespace glissade::bench {

/// Times of one scheme over some scenes, microseconds a history.
struct Times {
  std::size_t histories = 0;
  double median_us = 0.0, mean_us = 0.0;
};

/// One scheme: its time and its error.
struct SchemeResult {
  std::string family, label;
  Problem problem = Problem::none;
  bool exact = false;
  Times all, sliding;      ///< all thinned scenes; those of them that slide more than 1 mm
  std::size_t judged = 0;  ///< sliding scenes without uplift, which have an error
  double median_error = 0.0, largest_error = 0.0;  ///< of the peak, relative
  std::string worst_scene;
};

/// One exact scheme, or the floor, over a group of all standard scenes.
struct GroupResult {
  std::string scheme, group;
  Times times;
};

/// How far two exact schemes are apart on all standard scenes, uplift and free sliders included.
struct Agreement {
  std::string schemes, worst_scene;
  std::size_t histories = 0;                ///< that slide more than 1 mm
  double largest_difference = 0.0;          ///< of the peak, relative
  double largest_still_difference_m = 0.0;  ///< where they slide less
};

struct WorkPrecision {
  std::size_t scenes = 0;
  std::size_t compared = 0;           ///< the thinned ones
  std::size_t still = 0, uplift = 0;  ///< of those: slip less than 1 mm; lift off
  std::vector<SchemeResult> schemes;  ///< on the thinned scenes; the floor first
  std::vector<GroupResult> groups;    ///< on all scenes
  std::vector<Agreement> agreements;
};

/// @param all scenes to time the exact schemes and the floor on
/// @param stride all schemes are timed and judged on every stride-th of them
WorkPrecision work_precision(const test::StandardScenes& all, std::size_t stride, bool quick);

}  // namespace glissade::bench
