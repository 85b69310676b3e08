// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/study/config.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

/// The chart of a study's histories. A record and sample counts once at each point, with the
/// largest of its orientations.
Chart make_chart(const StudyConfig& config, const Results& results);

/// The answer to a question, by linear interpolation in slope and friction. Of a friction: the
/// least from which on slip stays within the displacement; +inf where it does not on this chart,
/// the chart's least friction where that does already. Next to a point that slides freely, the next
/// friction that does not.
/// @param levels the chart's; the question's level is one of them, slope and friction are within
/// the axes
ChartReading read_off(const Chart& chart, const std::vector<double>& levels,
                      const ChartQuestion& question);

}  // namespace glissade
