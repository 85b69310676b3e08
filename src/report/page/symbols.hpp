// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace glissade {

/// A page with its symbols set: "S_DS" with a subscript, "h^x" with a superscript. A symbol is one
/// letter; names of keys and files, drawings and listings stay as they are.
std::string with_symbols(const std::string& page);

}  // namespace glissade
