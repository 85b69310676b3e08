// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "clearance/plot.hpp"
#include "glissade/study/clearance_reading.hpp"

// What the figures that show suite means as lines share.
namespace glissade {

using Places = std::vector<ClearancePosition>;

/// All places of two axes, the others at their first.
Places places_of(const ClearanceGrid& grid, ClearanceAxis slow, ClearanceAxis fast);

/// The style of line `index` of a family of `count`.
std::string style_of(std::size_t index, std::size_t count);
/// The line of medians over the orientations at some places, and their range.
PlotLine line_through(const ClearanceResults& results, const ClearanceQuestion& question,
                      const Places& places, std::size_t index, std::size_t count,
                      Periods periods = Periods::one);
/// Lines over the building's period, one for each of `family`; axes told elsewhere are not in their
/// titles.
LinePlot over_periods(const ClearanceResults& results, const ClearanceQuestion& question,
                      const Places& family, const std::vector<ClearanceAxis>& told_elsewhere);

/// Leaves the bands that can be told apart, and says in the key what they are.
void tell_bands(const ClearanceResults& results, LinePlot& plot);

/// The figure drawn with these lines. Below its title stand the suite and every condition that is
/// the same all over: those of `shown`, the building's period and the support vary.
Figure with_lines(const ClearanceResults& results, Figure figure, std::vector<ClearanceAxis> shown,
                  const LinePlot& plot);

/// For captions: what a displacement is.
std::string what_is_averaged(const ClearanceResults& results);
/// For axes.
std::string displacement_label();

}  // namespace glissade
