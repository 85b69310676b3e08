// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace glissade {

/// A drawing of gnuplot with every symbol drawn where it is used, in its colour: WeasyPrint does
/// not pass the colour of a <use> on to what it refers to.
std::string printable(const std::string& svg);

}  // namespace glissade
