// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/published_table.hpp"

#include <map>

#include "glissade/core/error.hpp"

namespace glissade {
namespace {

/// A figure that takes published values.
struct PublishedFigure {
  std::string table;  ///< the analysis it is of
  NumberRule y;
};

const std::map<std::string, PublishedFigure>& published_figures() {
  constexpr NumberRule length{"0 or more", not_negative.is_met, "", "displacement_m"},
      slope{"0 or more", not_negative.is_met, "", "slope_deg"};
  static const std::map<std::string, PublishedFigure> figures = {
      {"chart_contours", {"chart", slope}},      {"chart_intensity", {"chart", length}},
      {"chart_slope_levels", {"chart", length}}, {"mce", {"clearance", length}},
      {"period", {"clearance", length}},         {"slope", {"clearance", length}},
      {"yielding", {"clearance", length}}};
  return figures;
}

std::string figure_names() {
  std::string names;
  for (const auto& [name, figure] : published_figures())
    names += (names.empty() ? "\"" : ", \"") + name + "\"";
  return names;
}

void read_figure(const TomlTable& table, const char* key, PublishedPoint& point) {
  point.figure = table.required_text(key, "give one of: " + figure_names());
  if (!point.figure.empty() && !published_figures().contains(point.figure))
    table.report(key, "there is no figure \"" + point.figure + "\" that takes published values",
                 "give one of: " + figure_names());
}

NumberRule rule_of_y(const PublishedPoint& point) {
  const auto figure = published_figures().find(point.figure);
  return figure == published_figures().end() ? any_finite : figure->second.y;
}

}  // namespace

const KeyTable<PublishedPoint>& published_table() {
  static const KeyTable<PublishedPoint> table = {
      "published",
      {{"figure", Reading{figure_names(), "required", read_figure},
        "[[published]] is a value of a publication, to be drawn in this figure"},
       {"x", requires_number<&PublishedPoint::x>(any_finite), "as on the figure's axis"},
       {"y",
        Reading{"number", "required",
                [](auto& table, auto key, auto& point) {
                  point.y = table.required_number(key, rule_of_y(point));
                }},
        "as on the figure's axis: a displacement in m, or a slope in degrees"},
       {"source", requires_text<&PublishedPoint::source>(),
        "publication and value, for the figure's key"}}};
  return table;
}

std::vector<PublishedPoint> read_published(const TomlTable& root) {
  std::vector<PublishedPoint> points;
  for (const TomlTable& table : root.tables("published")) {
    read_keys(published_table().keys, table, points.emplace_back());
    const auto figure = published_figures().find(points.back().figure);
    if (figure != published_figures().end() && !root.has(figure->second.table))
      table.report("figure",
                   figure->first + " is a figure of [" + figure->second.table +
                       "], which this study does not have",
                   "add that table, or leave the value out");
  }
  return points;
}

}  // namespace glissade
