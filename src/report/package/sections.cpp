// SPDX-License-Identifier: GPL-3.0-or-later
#include "package/sections.hpp"

#include <fmt/format.h>

#include <array>

namespace glissade {
namespace {

/// A heading that the contents point to.
struct SectionHead {
  Section section;
  Markup id;  ///< "#scope"
  Markup open;
  const char* title;
};
constexpr std::array<SectionHead, 16> heads{{
    {Section::scope, "<li><a href=\"#scope\">", "<h2 id=\"scope\">", "Scope and conditions"},
    {Section::criteria, "<li><a href=\"#criteria\">", "<h2 id=\"criteria\">", "Design criteria"},
    {Section::building, "<li><a href=\"#building\">", "<h2 id=\"building\">", "Building"},
    {Section::array, "<li><a href=\"#array\">", "<h2 id=\"array\">", "Array"},
    {Section::friction, "<li><a href=\"#friction\">", "<h2 id=\"friction\">", "Friction tests"},
    {Section::motions, "<li><a href=\"#motions\">", "<h2 id=\"motions\">", "Motions"},
    {Section::result, "<li><a href=\"#result\">", "<h2 id=\"result\">",
     "Analysis and governing displacement"},
    {Section::separations, "<li><a href=\"#separations\">", "<h2 id=\"separations\">",
     "Separations"},
    {Section::uncertainty, "<li><a href=\"#uncertainty\">", "<h2 id=\"uncertainty\">",
     "Model uncertainty"},
    {Section::probability, "<li><a href=\"#probability\">", "<h2 id=\"probability\">",
     "Probability of exceedance"},
    {Section::plausibility, "<li><a href=\"#plausibility\">", "<h2 id=\"plausibility\">",
     "Plausibility of the roof motions"},
    {Section::check, "<li><a href=\"#check\">", "<h2 id=\"check\">", "Independent check by hand"},
    {Section::provisions, "<li><a href=\"#provisions\">", "<h2 id=\"provisions\">",
     "Provisions used"},
    {Section::checks, "<li><a href=\"#checks\">", "<h2 id=\"checks\">",
     "Checks, limits and peer review"},
    {Section::references, "<li><a href=\"#references\">", "<h2 id=\"references\">", "References"},
    {Section::inputs, "<li><a href=\"#inputs\">", "<h2 id=\"inputs\">", "Program and input files"},
}};

}  // namespace

Html contents_html() {
  Html html("<div class=\"short\"><ul class=\"contents\">\n");
  for (const SectionHead& head : heads)
    html += enclosed(head.id, fmt::format("{}. {}", number_of(head.section), head.title),
                     "</a></li>\n");
  return html + "</ul></div>\n";
}

Html section_heading(Section section) {
  const SectionHead& head = heads.at(static_cast<std::size_t>(section));
  return enclosed(head.open, fmt::format("{}. {}", number_of(section), head.title), "</h2>\n");
}

Html page_table(const Table& table) {
  constexpr std::size_t most_rows = 13;
  return table.rows.size() > most_rows ? wide_table(table)
                                       : "<div class=\"short\">\n" + wide_table(table) + "</div>\n";
}

Html plain_table(const Table& table) {
  return "<div class=\"plain\">\n" + page_table(table) + "</div>\n";
}

Html equation(const std::string& text) {
  return enclosed("<p class=\"equation\">", text, "</p>\n");
}

}  // namespace glissade
