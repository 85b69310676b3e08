// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <utility>

#include "glissade/core/error.hpp"
#include "glissade/core/printable.hpp"

namespace glissade {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

}  // namespace

LineReader::LineReader(std::string_view text) : rest_(text) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
}

bool LineReader::next() {
  if (rest_.empty()) return false;
  const std::size_t end = rest_.find('\n');
  line_ = rest_.substr(0, end);
  if (line_.ends_with('\r')) line_.remove_suffix(1);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  ++number_;
  return true;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

bool is_blank_or_comment(std::string_view line) {
  const std::string_view text = trimmed(line);
  return text.empty() || text.front() == '#';
}

void refuse_separators(const std::string& where, std::string_view line,
                       std::string_view separators) {
  const std::size_t at = line.find_first_of(separators);
  if (at == std::string_view::npos || line.find(',') != std::string_view::npos) return;
  throw InputError(
      {where, std::string("columns are separated by ") + (line[at] == ';' ? "semicolons" : "tabs"),
       "separate them by commas, with points in numbers: 1.5, not 1,5 (\"CSV\" of a "
       "spreadsheet in English)",
       "  " + std::string(line.substr(0, 100))});
}

void refuse_no_text(const std::filesystem::path& file, std::string_view text) {
  using namespace std::string_view_literals;
  struct Foreign {
    std::string_view beginning;
    const char* what;
  };
  for (const auto& [beginning, what] :
       {Foreign{"PK\x03\x04"sv, "is a workbook of Excel (xlsx), or another compressed file"},
        Foreign{"\xd0\xcf\x11\xe0"sv, "is a workbook of Excel (xls)"},
        Foreign{"\xff\xfe"sv, "is UTF-16, as the \"Unicode Text\" of Excel is"},
        Foreign{"\xfe\xff"sv, "is UTF-16, as the \"Unicode Text\" of Excel is"}}) {
    if (text.starts_with(beginning))
      throw InputError({file.string(), what,
                        "save the sheet as CSV, with commas, in UTF-8 (\"CSV UTF-8\")", ""});
  }
  if (text.find('\0') != std::string::npos)
    throw InputError({file.string(), "is not a text file", "give a text file in UTF-8", ""});
}

bool FieldReader::next() {
  field_ = {};
  if (rest_.empty()) return std::exchange(ends_with_comma_, false);
  const auto is_end = [](char c) { return is_blank(c) || c == ','; };
  const auto end = std::find_if(rest_.begin(), rest_.end(), is_end);
  field_ = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
  rest_.remove_prefix(field_.size());
  while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
  ends_with_comma_ = rest_.starts_with(',');
  if (ends_with_comma_) rest_ = trimmed(rest_.substr(1));
  return true;
}

std::vector<std::string_view> fields(std::string_view line) {
  std::vector<std::string_view> parts;
  FieldReader reader(line);
  while (parts.size() + 1 < most_fields && reader.next()) parts.push_back(reader.field());
  if (!reader.rest().empty()) parts.push_back(reader.rest());
  return parts;
}

std::optional<double> parse_number(std::string_view text) {
  if (text.starts_with('+') && text.size() > 1 && text[1] != '-') text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || text.empty()) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    // Too small for a double is zero for every purpose; too large is no sample. Only an exponent
    // can make it small.
    return text.find("e-") != std::string_view::npos || text.find("E-") != std::string_view::npos
               ? std::optional<double>(0.0)
               : std::nullopt;
  }
  if (error != std::errc()) return std::nullopt;
  return value;
}

double to_twelve_digits(double value) {
  const std::string text = fmt::format("{:.12g}", value);
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::string shortest_decimal(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::size_t end = std::min(text.size(), longest);
  while (end < text.size() && end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u)
    --end;  // between two characters of UTF-8
  return "'" + printable_name(text.substr(0, end)) + (end < text.size() ? "...'" : "'");
}

std::string place(const std::filesystem::path& file, std::size_t line) {
  return file.string() + ":" + std::to_string(line);
}

}  // namespace glissade
