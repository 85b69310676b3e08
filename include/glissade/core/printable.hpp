// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace glissade {

/// The text with the characters that a terminal acts on (control characters, escape codes) or that
/// change the order of what is read (U+202E and the like) by their number, "\u001b", which is the
/// same character in JSON; bytes that are not UTF-8 as "\xff". Line ends and tabs stay.
std::string printable(std::string_view text);

/// The same of a name or a path: line ends and tabs by their number too.
std::string printable_name(std::string_view name);

bool is_utf8(std::string_view text);

}  // namespace glissade
