// SPDX-License-Identifier: GPL-3.0-or-later
#include "page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "glissade/report/format.hpp"

namespace glissade {
namespace {

constexpr auto style = R"(
body { font: 16px/1.5 Arial, Helvetica, sans-serif; color: #222; max-width: 68em; margin: 2em auto; padding: 0 1em; }
h1 { margin-bottom: 0; } h2 { margin-top: 2em; border-bottom: 1px solid #ccc; }
.answer { background: #eef4fa; border-left: 4px solid #0072b2; padding: .6em 1em; }
.answer p { margin: .4em 0; }
.warning { background: #fff4e0; border-left: 4px solid #e69f00; padding: .4em 1em; }
figure { margin: 1.5em auto; max-width: 60em; } figure svg { width: 100%; height: auto; }
figcaption, caption { color: #444; font-size: .9em; text-align: left; padding: .3em 0; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .85em; margin: 1em 0; }
th, td { border-bottom: 1px solid #ddd; padding: .2em .6em; text-align: left; vertical-align: top; }
th { background: #f4f4f4; vertical-align: bottom; } .number { text-align: right; white-space: nowrap; }
td:not(.number) { min-width: 7em; }
dt { font-weight: bold; } dd { margin: 0 0 .5em 1.5em; }
pre { background: #f7f7f7; border: 1px solid #ddd; padding: .8em; white-space: pre-wrap; overflow-wrap: anywhere; font-size: .85em; }
@media print {
  body { max-width: none; margin: 0; font-size: 10pt; } h2, figcaption { break-after: avoid; }
  figure { max-width: 14cm; } figure, tr { break-inside: avoid; } .wide { overflow: visible; } table { font-size: 7pt; }
}
)";

/// The drawing without what belongs to a file of its own (XML declaration, gnuplot's title, which
/// browsers show as a tooltip).
std::string inline_svg(const DrawnFigure& drawn) {
  std::string svg = drawn.svg.substr(std::min(drawn.svg.find("<svg"), drawn.svg.size()));
  const std::size_t title = svg.find("<title>Gnuplot</title>");
  if (title != std::string::npos) svg.erase(title, std::string("<title>Gnuplot</title>").size());
  if (svg.starts_with("<svg")) {
    svg.insert(4, " role=\"img\" aria-label=\"" + escape_html(drawn.figure.title) + "\"");
  }
  return svg;
}

}  // namespace

std::string page_head(const PageTitle& title) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         escape_html(title.name) + " - " + escape_html(title.kind) + "</title>\n<style>" + style +
         "</style>\n</head>\n<body>\n<h1>" + escape_html(title.name) + "</h1>\n";
}

std::string page_foot() { return "</body>\n</html>\n"; }

std::string paragraph(const std::string& text) { return "<p>" + escape_html(text) + "</p>\n"; }

std::string heading(const std::string& text) { return "<h2>" + escape_html(text) + "</h2>\n"; }

std::string wide_table(const Table& table) {
  return "<div class=\"wide\">" + to_html(table) + "</div>\n";
}

std::string list(const std::vector<std::string>& items) {
  std::string html = "<ul>\n";
  for (const std::string& item : items) html += "<li>" + escape_html(item) + "</li>\n";
  return html + "</ul>\n";
}

std::string figure_html(const DrawnFigure& drawn, std::size_t number) {
  return fmt::format(
      "<figure id=\"figure_{0}\">\n{1}\n<figcaption><strong>Figure {2}. {3}.</strong> "
      "{4}</figcaption>\n</figure>\n",
      drawn.figure.name, inline_svg(drawn), number, escape_html(drawn.figure.title),
      escape_html(drawn.figure.caption));
}

}  // namespace glissade
