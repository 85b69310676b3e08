// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>

#include "glissade/core/error.hpp"

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

void refuse_semicolons(const std::string& where, std::string_view line) {
  if (line.find(';') == std::string_view::npos || line.find(',') != std::string_view::npos) return;
  throw InputError({where, "columns are separated by semicolons",
                    "separate them by commas, with points in numbers: 1.5, not 1,5",
                    "  " + std::string(line.substr(0, 100))});
}

std::vector<std::string_view> fields(std::string_view line) {
  line = trimmed(line.substr(0, line.find('#')));
  std::vector<std::string_view> parts;
  while (!line.empty()) {
    const auto is_end = [](char c) { return is_blank(c) || c == ','; };
    const auto end = std::find_if(line.begin(), line.end(), is_end);
    parts.push_back(line.substr(0, static_cast<std::size_t>(end - line.begin())));
    line.remove_prefix(parts.back().size());
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    if (!line.empty() && line.front() == ',') {
      line = trimmed(line.substr(1));
      if (line.empty()) parts.emplace_back();
    }
  }
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
  std::string result = "'";
  for (const char c : text.substr(0, longest)) result += c >= 32 && c < 127 ? c : '?';
  return result + (text.size() > longest ? "...'" : "'");
}

std::string place(const std::filesystem::path& file, std::size_t line) {
  return file.string() + ":" + std::to_string(line);
}

}  // namespace glissade
