// SPDX-License-Identifier: GPL-3.0-or-later
#include "package/print/printable.hpp"

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

}  // namespace

std::string printable(const std::string& svg) {
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
