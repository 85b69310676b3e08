// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace glissade {

/// The columns of a terminal: help and tables are not wider.
inline constexpr std::size_t terminal_width = 80;

/// Characters on the screen: UTF-8 continuation bytes take none.
std::size_t display_width(std::string_view text);

/// The text in lines of at most `width` characters, broken at blanks and line ends; a longer word
/// is broken after '_', '/' or '-', and is else a line of its own. At least one line.
std::vector<std::string> wrapped(std::string_view text, std::size_t width);

/// The same as one text: every line but the first begins with `indent` blanks, which count.
std::string wrapped(std::string_view text, std::size_t width, std::size_t indent);

/// "1 sample", "2 samples"
std::string counted(std::size_t count, const std::string& one);

}  // namespace glissade
