// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "glissade/report/figure.hpp"

namespace glissade {

/// gnuplot's drawing of a figure with a title at each point that says what it is, "84th percentile:
/// 1.23, 2.6 in (0.066 m)", which browsers show, and without the titles that only number the plots.
/// Of several panels no point has a title.
std::string with_tooltips(std::string svg, const Figure& figure);

}  // namespace glissade
