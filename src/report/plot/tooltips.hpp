// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "glissade/report/figure.hpp"

namespace glissade {

/// gnuplot's drawing of a figure with a title at each point that says what it is, "84th percentile:
/// Period (s) 1.23, Displacement 2.6 in (0.066 m)", and at each line its name, which browsers show,
/// in place of the titles that only number the plots.
std::string with_tooltips(const std::string& svg, const Figure& figure);

}  // namespace glissade
