// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace glissade {

/// A name that means nothing but itself in a path, a script and a page: a to z, 0 to 9, _ and -, at
/// most 64 characters. Names that were read from a file become parts of file names only as this.
class FileName {
 public:
  static bool accepts(std::string_view text);
  /// Throws InputError for any other text.
  FileName(std::string text);
  FileName(const char* text) : FileName(std::string(text)) {}

  const std::string& text() const { return text_; }
  operator const std::string&() const { return text_; }
  bool operator==(const FileName&) const = default;

 private:
  std::string text_;
};

inline std::string operator+(const FileName& name, const std::string& ending) {
  return name.text() + ending;
}

}  // namespace glissade
