// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cctype>
#include <string>
#include <string_view>
#include <utility>

namespace glissade {

/// A text on motions of the ground and on buildings, on motions of a roof, below which none is
/// computed: "PGA of 4 g" becomes "peak roof acceleration of 4 g", and no period is named.
inline std::string in_words_of_roof(std::string text) {
  constexpr std::pair<std::string_view, std::string_view> words[] = {
      {"PGA", "peak roof acceleration"},
      {"PGV", "peak roof velocity"},
      {"PGD", "peak roof displacement"},
      {"motion of the ground", "motion of the roof"},
      {" is largest at T = 0 s. The largest over the periods is ", " is "},
      {", the largest over the building periods", ""},
      {" over the periods", ""},
      {" (at T = 0 s)", ""},
      {" at T = 0 s", ""},
      {"building of T 0 s", "mean"}};
  for (const auto& [of_ground, of_roof] : words)
    for (std::size_t at; (at = text.find(of_ground)) != std::string::npos;) {
      text.replace(at, of_ground.size(), of_roof);
      const bool begins = at == 0 || (at > 1 && text[at - 2] == '.');
      if (begins && at < text.size())
        text[at] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[at])));
    }
  return text;
}

}  // namespace glissade
