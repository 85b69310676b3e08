// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/file_name.hpp"

#include <utility>

#include "glissade/core/error.hpp"

namespace glissade {

bool FileName::accepts(std::string_view text) {
  constexpr std::size_t most = 64;
  constexpr std::string_view allowed = "abcdefghijklmnopqrstuvwxyz0123456789_-";
  return !text.empty() && text.size() <= most &&
         text.find_first_not_of(allowed) == std::string_view::npos;
}

FileName::FileName(std::string text) : text_(std::move(text)) {
  if (!accepts(text_))
    throw InputError({"the name '" + text_ + "'", "cannot be part of a file name",
                      "use a to z, 0 to 9, _ and -, at most 64 characters", ""});
}

}  // namespace glissade
