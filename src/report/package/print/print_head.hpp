// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "page/page.hpp"

namespace glissade {

inline constexpr Markup letter = "@page { size: letter; } @page wide { size: letter landscape; }";
inline constexpr Markup a4 = "@page { size: A4; } @page wide { size: A4 landscape; }";

/// What stands at the foot of each page.
struct Footer {
  std::string name, revision = {}, date = {};  ///< the last two may be empty
  bool is_simulated = false;                   ///< the motions are: the page says so
};
/// All up to and with the <h1> of a page to be printed.
Html print_head(const PageTitle& title, const Footer& footer);
/// Nothing of none.
Html warnings_box(const std::vector<std::string>& warnings);

}  // namespace glissade
