// SPDX-License-Identifier: GPL-3.0-or-later
#include "toml/source_text.hpp"

#include <algorithm>
#include <string_view>

#include "text/scan.hpp"

namespace glissade {
namespace {

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; }

}  // namespace

SourceText::SourceText(std::string text) : text_(std::move(text)) {
  LineReader reader(text_);
  while (reader.next())
    line_begins_.push_back(static_cast<std::size_t>(reader.line().data() - text_.data()));
}

std::size_t SourceText::offset_of(const toml::source_position& at) const {
  if (at.line == 0 || at.line > line_begins_.size()) return text_.size();
  std::size_t place = line_begins_[at.line - 1];
  for (std::size_t column = 1; column < at.column && place < text_.size(); ++column) {
    do ++place;
    while (place < text_.size() && is_continuation(text_[place]));
  }
  return place;
}

std::string SourceText::excerpt(const toml::source_position& at) const {
  if (at.line == 0 || at.line > line_begins_.size() || at.column == 0) return {};
  LineReader reader(std::string_view(text_).substr(line_begins_[at.line - 1]));
  if (!reader.next()) return {};
  const std::string_view line = reader.line();
  const std::size_t caret = std::min(offset_of(at) - line_begins_[at.line - 1], line.size());
  constexpr std::size_t shown_before = 60, shown_after = 40;
  std::size_t begin = caret > shown_before ? caret - shown_before : 0;
  while (begin < caret && is_continuation(line[begin])) ++begin;
  std::size_t end = std::min(line.size(), caret + shown_after);
  while (end < line.size() && is_continuation(line[end])) ++end;
  std::string padding;
  for (std::size_t i = begin; i < caret; ++i) {
    if (!is_continuation(line[i])) padding += line[i] == '\t' ? '\t' : ' ';
  }
  return "  " + std::string(line.substr(begin, end - begin)) + "\n  " + padding + "^";
}

toml::table parse_toml(const std::string& text) {
  // Each point of a dotted name is a table in a table, which toml++ takes down by recursion.
  constexpr auto most_points = 2000;
  LineReader reader(text);
  while (reader.next()) {
    if (std::ranges::count(reader.line(), '.') <= most_points) continue;
    const toml::source_position at{static_cast<toml::source_index>(reader.number()), 1};
    throw toml::parse_error(
        "more than 2000 points in a line: a list needs more lines, and names nest less deeply", at);
  }
  return toml::parse(text);
}

}  // namespace glissade
