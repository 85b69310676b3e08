// SPDX-License-Identifier: GPL-3.0-or-later
#include "toml/source_text.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <sstream>
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

std::string text_of(const toml::table& root) {
  std::ostringstream form;
  form << root << "\n";
  return form.str();
}

namespace {

/// Where strings begin, and where they end.
void collect_strings(const toml::node& node, const SourceText& source,
                     std::map<std::size_t, std::size_t>& strings) {
  if (const toml::table* table = node.as_table())
    for (const auto& [key, value] : *table) collect_strings(value, source, strings);
  else if (const toml::array* list = node.as_array())
    for (const toml::node& value : *list) collect_strings(value, source, strings);
  else if (node.is_string())
    strings[source.offset_of(node.source().begin)] = source.offset_of(node.source().end);
}

}  // namespace

std::string without_comments(const std::string& text) {
  std::map<std::size_t, std::size_t> strings;
  collect_strings(parse_toml(text), SourceText(text), strings);
  const auto is_in_string = [&](std::size_t at) {
    const auto behind = strings.upper_bound(at);
    return behind != strings.begin() && at < std::prev(behind)->second;
  };
  std::string kept;
  for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end + 1) {
    end = std::min(text.find('\n', begin), text.size());
    std::string line;
    for (std::size_t at = begin; at < end && (text[at] != '#' || is_in_string(at)); ++at)
      line += text[at];
    if (!is_in_string(end)) line.erase(line.find_last_not_of(" \t\r") + 1);
    if (line.empty() && !is_in_string(end)) continue;
    if (line.starts_with('[') && !is_in_string(begin) && !kept.empty()) kept += '\n';
    kept += line + '\n';
  }
  return kept;
}

}  // namespace glissade
