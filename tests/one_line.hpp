// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <regex>
#include <string>

namespace glissade::test {

/// A text that was broken between words, as one line.
inline std::string one_line(const std::string& text) {
  return std::regex_replace(text, std::regex("\\n +"), " ");
}

}  // namespace glissade::test
