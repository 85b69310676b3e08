// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace glissade {

/// A drawing of gnuplot with every symbol drawn where it is used, in its colour, and every text
/// with subscripts placed by its beginning: WeasyPrint does not pass the colour of a <use> on to
/// what it refers to, and centres each part of a text by itself.
std::string printable(const std::string& drawing);

}  // namespace glissade
