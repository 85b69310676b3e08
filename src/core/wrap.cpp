// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/wrap.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace glissade {
namespace {

/// A text that is not broken, with the blanks before it; `begins_line` after a line end.
struct Piece {
  std::string_view text;
  std::size_t blanks = 0;
  bool begins_line = false;
};

/// Words; those longer than a line in parts.
std::vector<Piece> pieces_of(std::string_view text, std::size_t width) {
  std::vector<Piece> pieces;
  Piece next;
  while (!text.empty()) {
    if (text.front() == ' ' || text.front() == '\n') {
      next.blanks = text.front() == ' ' ? next.blanks + 1 : 0;
      next.begins_line = next.begins_line || text.front() == '\n';
      text.remove_prefix(1);
      continue;
    }
    std::size_t end = std::min(text.find_first_of(" \n"), text.size());
    if (display_width(text.substr(0, end)) > width) {
      const std::size_t part = text.substr(0, end).find_last_of("_/-", width - 1);
      if (part != std::string_view::npos) end = part + 1;
    }
    next.text = text.substr(0, end);
    pieces.push_back(next);
    next = {};
    text.remove_prefix(end);
  }
  return pieces;
}

}  // namespace

std::size_t display_width(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u;
  }));
}

std::vector<std::string> wrapped(std::string_view text, std::size_t width) {
  std::vector<std::string> lines(1);
  for (const Piece& piece : pieces_of(text, width)) {
    const bool fits =
        display_width(lines.back()) + piece.blanks + display_width(piece.text) <= width;
    if (piece.begins_line || (!lines.back().empty() && !fits)) {
      lines.emplace_back(piece.text);
    } else {
      lines.back() += std::string(piece.blanks, ' ') + std::string(piece.text);
    }
  }
  return lines;
}

std::string wrapped(std::string_view text, std::size_t width, std::size_t indent) {
  std::string all;
  for (const std::string& line : wrapped(text, width - indent))
    all += (all.empty() ? "" : "\n" + std::string(indent, ' ')) + line;
  return all;
}

std::string counted(std::size_t count, const std::string& one) {
  return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

}  // namespace glissade
