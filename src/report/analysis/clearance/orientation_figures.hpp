// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "glissade/report/figure.hpp"
#include "glissade/study/analysis/conditions/suite_mean.hpp"

namespace glissade {

/// The displacement in each orientation, where they are few; with two frictions the clearance by
/// slope and axis.
std::optional<Figure> orientation_figure(const Results& results);

}  // namespace glissade
