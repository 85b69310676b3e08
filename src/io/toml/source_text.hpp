// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <toml++/toml.h>

#include <cstddef>
#include <string>
#include <vector>

namespace glissade {

/// The text of a TOML file, in which its parser counts lines and columns (of code points) from 1.
class SourceText {
 public:
  explicit SourceText(std::string text);
  const std::string& text() const { return text_; }
  /// In bytes; of the file's end where there is no such place.
  std::size_t offset_of(const toml::source_position& at) const;
  /// The line with a caret below a column. Long lines are cut around it.
  std::string excerpt(const toml::source_position& at) const;

 private:
  std::string text_;
  std::vector<std::size_t> line_begins_;
};

/// Throws toml::parse_error where it is not TOML, or nests deeper than a stack may be.
toml::table parse_toml(const std::string& text);
/// The tables as text.
std::string text_of(const toml::table& root);
/// The text of a file that is TOML without its comments and empty lines.
std::string without_comments(const std::string& text);

}  // namespace glissade
