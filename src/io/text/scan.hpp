// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "glissade/core/error.hpp"

namespace glissade {

/// Iterates over the lines of a text, without \n or \r\n, counting from 1. A byte order mark is
/// skipped.
class LineReader {
 public:
  explicit LineReader(std::string_view text);
  bool next();
  std::string_view line() const { return line_; }
  std::size_t number() const { return number_; }

 private:
  std::string_view rest_, line_;
  std::size_t number_ = 0;
};

std::string_view trimmed(std::string_view text);
std::string lower_case(std::string_view text);
bool is_blank_or_comment(std::string_view line);  ///< `#` begins a comment

/// The parts of a line between blanks, tabs and commas, one by one; two commas have an empty part
/// between them. What follows `#` is dropped.
class FieldReader {
 public:
  explicit FieldReader(std::string_view line) : rest_(trimmed(line.substr(0, line.find('#')))) {}
  bool next();
  std::string_view field() const { return field_; }
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_, field_;
  bool ends_with_comma_ = false;
};

/// The most parts that a list of a line's parts has; the last one then holds all that is left, and
/// is no number.
inline constexpr std::size_t most_fields = 100'000;
/// All parts of a line.
std::vector<std::string_view> fields(std::string_view line);
/// Throws InputError where a header's columns are separated by one of these, ";" or tabs, and by no
/// commas.
void refuse_separators(const std::string& where, std::string_view line,
                       std::string_view separators);

/// Throws InputError, with what the file is, for a workbook of Excel, UTF-16 and anything else that
/// is no text in UTF-8 or ASCII.
void refuse_no_text(const std::filesystem::path& file, std::string_view text);

/// The whole of `text` as a number, with an optional leading '+'; nothing if it is anything else.
/// May be inf or nan.
std::optional<double> parse_number(std::string_view text);

/// The shortest decimal that reads back as the same double; "nan", "inf" and "-inf" where it is
/// none.
std::string shortest_decimal(double value);

/// 0.3 for 0.30000000000000004, as people write it.
double to_twelve_digits(double value);

/// For error messages: printable, at most 40 characters, in quotes.
std::string in_quotes(std::string_view text);

/// "file:line".
std::string place(const std::filesystem::path& file, std::size_t line);

}  // namespace glissade
