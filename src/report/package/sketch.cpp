// SPDX-License-Identifier: GPL-3.0-or-later
#include "package/sketch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "glissade/core/units.hpp"
#include "package/tables.hpp"
#include "package/units.hpp"

namespace glissade {
namespace {

/// In the units of the drawing, pixels from its upper left corner.
struct PlanPoint {
  double x = 0.0, y = 0.0;
};

/// SVG, piece by piece.
class Drawing {
 public:
  void rectangle(PlanPoint at, double width, double height, const char* style) {
    body_ +=
        fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" {}/>\n",
                    at.x, at.y, width, height, style);
  }
  void line(PlanPoint from, PlanPoint to, const char* style = "stroke=\"#222\"") {
    body_ += fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n",
                         from.x, from.y, to.x, to.y, style);
  }
  void text(PlanPoint at, const std::string& words,
            const std::string& style = "text-anchor=\"middle\"") {
    body_ +=
        fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", at.x, at.y, style, words);
  }
  /// A dimension line with ticks at its ends.
  void dimension(PlanPoint from, PlanPoint to) {
    constexpr double tick = 4.0;
    line(from, to, "stroke=\"#d55e00\" stroke-width=\"1.5\"");
    for (const PlanPoint end : {from, to})
      line({end.x - tick, end.y + tick}, {end.x + tick, end.y - tick},
           "stroke=\"#d55e00\" stroke-width=\"1.5\"");
  }
  std::string svg(double width, double height) const {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
        "width=\"{0:.0f}\" "
        "height=\"{1:.0f}\" font-family=\"Liberation Sans, Arial, sans-serif\" font-size=\"13\">\n"
        "{2}</svg>\n",
        width, height, body_);
  }

 private:
  std::string body_;
};

std::ptrdiff_t most_of_a_kind(const std::vector<ProjectSeparation>& separations) {
  std::ptrdiff_t most = 0;
  for (const ProjectSeparation& s : separations)
    most = std::max(most, std::ranges::count(separations, s.kind, &ProjectSeparation::kind));
  return most;
}

}  // namespace

std::string separations_sketch(const CalculationPackage& package) {
  const std::vector<ProjectSeparation>& all = package.design.separations;
  constexpr double width = 840.0, array_height = 110.0, left = 30.0;
  constexpr auto module = "fill=\"#dce9f5\" stroke=\"#0072b2\" stroke-width=\"1.5\"";
  constexpr auto fixed = "fill=\"#ddd\" stroke=\"#444\" stroke-width=\"1.5\"";
  // From the parapet to the open edge three gaps in a row; they take up to half of the width.
  const auto gap_m = [&](std::size_t kind) {
    return std::ranges::find(all, kind, &ProjectSeparation::kind)->required.value_m;
  };
  const double row_m = gap_m(2) + gap_m(0) + gap_m(3);
  const double per_m = std::min(0.5 * (width - 2.0 * left) / row_m, 110.0 / gap_m(1));
  const double array_width = (width - 2.0 * left - per_m * row_m) / 2.0;
  constexpr double roof_top = 8.0, unit_height = 44.0, unit = roof_top + 30.0 + unit_height;
  const double top = unit + per_m * gap_m(1), bottom = top + array_height,
               roof_bottom = bottom + 45.0 + 15.0 * static_cast<double>(most_of_a_kind(all));
  const double parapet = left, first = parapet + per_m * gap_m(2),
               second = first + array_width + per_m * gap_m(0),
               edge = second + array_width + per_m * gap_m(3);

  Drawing drawing;
  drawing.rectangle({parapet, roof_top}, edge - parapet, roof_bottom - roof_top,
                    "fill=\"#fbfbf8\" stroke=\"none\"");
  drawing.line({parapet - 3.0, roof_top}, {parapet - 3.0, roof_bottom},
               "stroke=\"#444\" stroke-width=\"6\"");
  drawing.line({edge, roof_top}, {edge, roof_bottom},
               "stroke=\"#444\" stroke-width=\"1.5\" stroke-dasharray=\"8 4\"");
  for (const double x : {first, second})
    drawing.rectangle({x, top}, array_width, array_height, module);
  drawing.text({first + array_width / 2.0, top + array_height / 2.0}, "array");
  drawing.text({second + array_width / 2.0, top + array_height / 2.0}, "similar array");
  drawing.rectangle({second + 0.3 * array_width, unit - unit_height}, 0.4 * array_width,
                    unit_height, fixed);
  drawing.text({second + 0.5 * array_width, unit - unit_height / 2.0 + 5.0}, "fixed object");
  // Names stay in the table: the sketch has its letters.
  const auto write = [&](PlanPoint at, std::size_t kind, const std::string& anchor) {
    std::string letters;
    std::vector<std::string> available;
    for (std::size_t row = 0; row < all.size(); ++row) {
      if (all[row].kind != kind) continue;
      const std::string letter = separation_letter(row);
      letters += (letters.empty() ? "" : ", ") + letter;
      if (!all[row].available_m) continue;
      const bool is_short = *all[row].available_m < all[row].required.value_m;
      available.push_back(letter + " available " + length_in(*all[row].available_m) +
                          (is_short ? ": NOT SUFFICIENT" : ""));
    }
    std::size_t characters = letters.size() + 10;
    for (const std::string& line : available) characters = std::max(characters, line.size());
    const double half = 3.4 * static_cast<double>(characters);  // clear of the edges of the roof
    if (anchor == "middle") at.x = std::clamp(at.x, parapet + half, edge - half);
    drawing.text(at, letters + ": " + length_in(gap_m(kind)),
                 "text-anchor=\"" + anchor + "\" font-weight=\"bold\"");
    for (const std::string& line : available)
      drawing.text({at.x, at.y += 15.0}, line, "text-anchor=\"" + anchor + "\" fill=\"#444\"");
  };
  const double row = bottom + 14.0;
  for (const auto& [from, to, i] : {std::tuple(parapet, first, 2),
                                    {first + array_width, second, 0},
                                    {second + array_width, edge, 3}}) {
    drawing.dimension({from, row}, {to, row});
    write({(from + to) / 2.0, row + 20.0}, static_cast<std::size_t>(i), "middle");
  }
  const double middle = second + 0.5 * array_width;
  drawing.dimension({middle, unit}, {middle, top});
  write({middle + 10.0, (unit + top) / 2.0 - 2.0}, 1, "start");
  drawing.text({parapet + 6.0, roof_top + 14.0}, "edge with a qualifying parapet",
               "text-anchor=\"start\" fill=\"#444\"");
  drawing.text({edge - 6.0, roof_top + 14.0}, "edge without one",
               "text-anchor=\"end\" fill=\"#444\"");
  const double scale_m = in_inches() ? foot_m : 0.5;
  const PlanPoint scale{parapet, roof_bottom + 24.0};
  drawing.line(scale, {scale.x + per_m * scale_m, scale.y}, "stroke=\"#222\" stroke-width=\"3\"");
  drawing.text(
      {scale.x + per_m * scale_m + 8.0, scale.y + 5.0},
      std::string(in_inches() ? "1 ft" : "0.5 m") + ", of the gaps; arrays are not to scale",
      "text-anchor=\"start\"");
  return drawing.svg(width, roof_bottom + 40.0);
}

}  // namespace glissade
