// SPDX-License-Identifier: GPL-3.0-or-later
#include "package/print/printable.hpp"

#include <fmt/format.h>

#include <string_view>

namespace glissade {
namespace {

/// Of a tag as gnuplot writes it: NAME='VALUE'.
std::string attribute(std::string_view tag, const std::string& name) {
  const std::string begin = " " + name + "='";
  const std::size_t at = tag.find(begin);
  if (at == std::string_view::npos) return "";
  const std::size_t first = at + begin.size();
  return std::string(tag.substr(first, tag.find('\'', first) - first));
}

/// A group with what a <use> adds to what it refers to.
std::string group_of(std::string_view use) {
  std::string group = "<g";
  for (const char* name : {"transform", "fill", "stroke"})
    if (const std::string value = attribute(use, name); !value.empty())
      group += std::string(" ") + name + "='" + value + "'";
  return group + ">";
}

/// The definition that a <use> refers to, without its name.
std::string referred_by(const std::string& svg, std::string_view use) {
  const std::string id = " id='" + attribute(use, "xlink:href").substr(1) + "'";
  const std::size_t at = svg.find(id), begin = svg.rfind('<', at), end = svg.find("/>", at) + 2;
  std::string found = svg.substr(begin, end - begin);
  if (found.starts_with("<use")) return group_of(found) + referred_by(svg, found) + "</g>";
  return found.erase(found.find(id), id.size());
}

/// Of Helvetica, over the size of the letters.
double width_of(char c) {
  struct Letters {
    std::string_view letters;
    double width;
  };
  for (const auto& [letters, width] : {Letters{"ijl'|", 0.22},
                                       {" ftI!,.:;/[]", 0.28},
                                       {"r-()", 0.33},
                                       {"cksvxyzJ", 0.5},
                                       {"FTZL", 0.61},
                                       {"ABEKPSVXY", 0.67},
                                       {"CDHNRUw", 0.72},
                                       {"GOQ", 0.78},
                                       {"mM", 0.83}})
    if (letters.find(c) != std::string_view::npos) return width;
  const bool continues = (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;  // of UTF-8
  return continues ? 0.0 : 0.56;
}

/// Of all parts, <tspan ... font-size="14.7" ...>text</tspan>.
double width_of_text(std::string_view text, double size) {
  constexpr std::string_view key = "font-size=\"";
  double width = 0.0;
  for (std::size_t at = text.find("<tspan"); at != std::string_view::npos;
       at = text.find("<tspan", at)) {
    const std::size_t open = text.find('>', at), close = text.find("</tspan>", open);
    const std::size_t of_part = text.substr(at, open - at).find(key);
    const double part = of_part == std::string_view::npos
                            ? size
                            : std::stod(std::string(text.substr(at + of_part + key.size(), 8)));
    for (const char c : text.substr(open + 1, close - open - 1)) width += part * width_of(c);
    at = close;
  }
  return width;
}

/// Texts of several parts begin where they would if they were centred, or ended, as a whole.
std::string with_placed_texts(std::string svg) {
  constexpr std::string_view open = "<text>", anchor = "text-anchor=\"";
  for (std::size_t at = svg.find(open); at != std::string::npos; at = svg.find(open, at + 1)) {
    const std::string text = svg.substr(at, svg.find("</text>", at) - at);
    if (text.find("<tspan") == text.rfind("<tspan")) continue;
    const std::size_t group = svg.rfind("<g ", at), of = svg.find(anchor, group) + anchor.size();
    if (of > at) continue;
    const std::string where = svg.substr(of, svg.find('"', of) - of);
    const double share = where == "middle" ? 0.5 : where == "end" ? 1.0 : 0.0;
    constexpr double usual_size = 16.0;
    const std::string begin =
        fmt::format("<text x=\"{:.1f}\">", -share * width_of_text(text, usual_size));
    svg.replace(at, open.size(), begin);
    svg.replace(of, where.size(), "start");
  }
  return svg;
}

}  // namespace

std::string printable(const std::string& drawing) {
  const std::string svg = with_placed_texts(drawing);
  constexpr std::string_view open = "<use ", close = "</use>", current = "currentColor";
  std::string drawn;
  std::size_t done = 0;
  for (std::size_t at = svg.find(open); at != std::string::npos; at = svg.find(open, done)) {
    const std::size_t end = svg.find('>', at) + 1;
    const std::string_view tag = std::string_view(svg).substr(at, end - at);
    drawn.append(svg, done, at - done);
    done = end;
    if (!attribute(tag, "id").empty()) {  // a definition
      drawn += tag;
      continue;
    }
    std::string symbol = group_of(tag) + referred_by(svg, tag);
    const std::string colour = attribute(tag, "color");
    for (std::size_t i = symbol.find(current); i != std::string::npos; i = symbol.find(current))
      symbol.replace(i, current.size(), colour);
    drawn += symbol;
    if (!tag.ends_with("/>")) {
      const std::size_t last = svg.find(close, end);
      drawn.append(svg, end, last - end);
      done = last + close.size();
    }
    drawn += "</g>";
  }
  return drawn.append(svg, done);
}

}  // namespace glissade
