// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "glissade/report/figure.hpp"
#include "glissade/study/analysis/clearance_reading.hpp"

namespace glissade {

/// The displacement in each orientation, where they are few; with two frictions the clearance by
/// slope and axis.
std::optional<Figure> orientation_figure(const ClearanceResults& results);

}  // namespace glissade
