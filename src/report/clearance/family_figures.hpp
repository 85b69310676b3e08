// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "glissade/report/figures.hpp"
#include "glissade/study/clearance_reading.hpp"

// The figures of a clearance study that show suite means as lines. Each expects that its topic can
// be told (view.hpp).
namespace glissade {

/// Displacement over the building's period, by m/M and vertical (Walters et al. 2012, Fig. 13).
Figure period_figure(const ClearanceResults& results);
/// The same in each orientation, where they are few; with two frictions the clearance by slope and
/// axis.
std::optional<Figure> orientation_figure(const ClearanceResults& results);
/// Displacement over the suites (Fig. 14).
Figure level_figure(const ClearanceResults& results);
/// Displacement over R, relative to the elastic building's (Fig. 15).
Figure yielding_figure(const ClearanceResults& results);
/// Base shear over the period by support (Fig. 16).
Figure base_shear_figure(const ClearanceResults& results);
/// The same over that without an array, which must be among the supports.
Figure base_shear_ratio_figure(const ClearanceResults& results);
/// Displacement over slope by period (Fig. 17).
Figure slope_figure(const ClearanceResults& results);
/// Displacement over the period by level (Fig. 18).
Figure mce_figure(const ClearanceResults& results);
/// Displacement over the roof's vertical period by the building's.
Figure vertical_figure(const ClearanceResults& results);

}  // namespace glissade
