// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "page/page.hpp"

namespace glissade {

inline constexpr Markup letter = "@page { size: letter; } @page wide { size: letter landscape; }";
inline constexpr Markup a4 = "@page { size: A4; } @page wide { size: A4 landscape; }";

/// All up to and with the <h1> of a page to be printed. @param footer at the foot of each page
Html print_head(const PageTitle& title, const std::string& footer);

/// At the foot of each page.
inline constexpr const char* simulated_footer = ". SIMULATED MOTIONS: NOT FOR A PERMIT";

/// A file without its comments, which are those of an example.
std::string without_comments(const std::string& toml);

}  // namespace glissade
