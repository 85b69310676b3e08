// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "analysis/chart/report.hpp"
#include "analysis/chart/view.hpp"
#include "glissade/core/units.hpp"
#include "glissade/report/format.hpp"
#include "glissade/standards/conditions.hpp"
#include "plot/contour_lines.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

/// Round numbers between the ends: 1, 1.5, 2, 3, 4, 5, 10 ..., or 1, 2, 5, 10 ... where those are
/// too many to read.
std::vector<double> round_between(double low, double high) {
  constexpr std::size_t most = 9;
  std::vector<double> found;
  for (const std::vector<double>& digits :
       {std::vector{1.0, 1.5, 2.0, 3.0, 4.0, 5.0}, std::vector{1.0, 2.0, 5.0}}) {
    found.clear();
    for (int decade = -3; decade <= 3; ++decade) {
      for (const double digit : digits) {
        const double value = std::stod(fmt::format("{}e{}", digit, decade));
        if (low < value && value < high) found.push_back(value);
      }
    }
    if (found.size() <= most) break;
  }
  return found;
}

/// The contours in the unit that stands first: from the least slip of the grid to the largest, as
/// far as a clearance is built.
std::vector<double> contour_values(const GridValues& grid) {
  const bool si = LengthUnits::first() == UnitSystem::si;
  double low_m = std::numeric_limits<double>::infinity();
  for (const double slip_m : grid.z)
    if (slip_m > 0.0) low_m = std::min(low_m, slip_m);
  const double least = si ? 0.009 : 0.4, most = si ? 6.0 : 210.0;
  return round_between(std::max(in_first_unit(low_m), least),
                       std::min(in_first_unit(largest(grid.z)), most));
}

/// Where text stands, as shares of the plot's width and height.
struct TextBox {
  PlanePoint centre;
  double width = 0.0, height = 0.0;
};

TextBox text_box(const std::string& text) {
  constexpr double character = 0.0108, margin = 0.015, line = 0.08;
  return {{}, character * static_cast<double>(text.size()) + margin, line};
}

bool overlap(const TextBox& a, const TextBox& b) {
  return std::abs(a.centre.x - b.centre.x) < 0.5 * (a.width + b.width) &&
         std::abs(a.centre.y - b.centre.y) < 0.5 * (a.height + b.height);
}

bool inside(const TextBox& box) {
  return std::abs(box.centre.x - 0.5) + 0.5 * box.width < 0.5 &&
         std::abs(box.centre.y - 0.5) + 0.5 * box.height < 0.5;
}

void append(DataSeries& series, const Polyline& line) {
  for (const PlanePoint& point : line) series.add(point.x, point.y);
}

/// So many that no text fits between two of them.
Polyline with_points_between(const Polyline& ends) {
  constexpr int parts = 16;
  Polyline line;
  for (std::size_t i = 1; i < ends.size(); ++i)
    for (int part = i == 1 ? 0 : 1; part <= parts; ++part) {
      const double share = static_cast<double>(part) / parts;
      line.push_back(
          {std::lerp(ends[i - 1].x, ends[i].x, share), std::lerp(ends[i - 1].y, ends[i].y, share)});
    }
  return line;
}

/// What is drawn: the panel grows by lines and labels that keep clear of each other.
class ContourPlot {
 public:
  explicit ContourPlot(GridValues grid) : grid_(std::move(grid)) {
    panel_.x = {"Coefficient of friction", grid_.x.front(), grid_.x.back()};
    panel_.y = {"Roof slope (degrees)", grid_.y.front(), grid_.y.back()};
  }

  /// Lines at a value with their label, and whether there are any.
  bool add(const std::string& name, double value_m, const std::string& text, const Look& look,
           const std::string& key = "") {
    if (value_m > largest(grid_.z)) return false;  // beside the free region alone
    const std::vector<Polyline> lines = contour_lines(grid_, value_m);
    if (lines.empty()) return false;
    DataSeries series{DataSeries::Kind::line, look, name, key};
    for (const Polyline& line : lines) {
      append(series, line);
      series.end_line();
    }
    panel_.series.push_back(std::move(series));
    labels_.push_back({text, look.colour, lines, panel_.series.size() - 1});
    return true;
  }

  /// A line or an area of the reader's map that is no contour, named in the key.
  void add_outline(DataSeries series, const Polyline& points) {
    append(series, points);
    if (series.kind == DataSeries::Kind::line) outlines_.push_back(with_points_between(points));
    panel_.series.push_back(std::move(series));
  }

  /// With a label on each contour; without those that have no room for one.
  Panel labelled() {
    for (const Label& label : labels_) {
      DataSeries& series = panel_.series[label.series];
      if (const auto place = place_of(label))
        panel_.notes.push_back({place->x, place->y, label.text, label.colour});
      else if (series.label.empty())
        series.x.clear();
    }
    return panel_;
  }

 private:
  struct Label {
    std::string text;
    Colour colour;
    std::vector<Polyline> lines;
    std::size_t series;
  };

  PlanePoint share(const PlanePoint& p) const {
    return {(p.x - grid_.x.front()) / (grid_.x.back() - grid_.x.front()),
            (p.y - grid_.y.front()) / (grid_.y.back() - grid_.y.front())};
  }

  /// At points of the line that are close to each other.
  bool crosses(const TextBox& box, const Polyline& line) const {
    constexpr int parts = 8;
    for (std::size_t i = 1; i < line.size(); ++i) {
      for (int part = 0; part <= parts; ++part) {
        const double along = static_cast<double>(part) / parts;
        if (overlap(box, {share({std::lerp(line[i - 1].x, line[i].x, along),
                                 std::lerp(line[i - 1].y, line[i].y, along)})}))
          return true;
      }
    }
    return false;
  }

  /// On the longest line, clear of other text, if possible of other lines, and as near as can be to
  /// the falling diagonal, which all lines cross: slip grows with slope and falls with friction.
  std::optional<PlanePoint> place_of(const Label& label) {
    TextBox box = text_box(label.text);
    std::optional<PlanePoint> best;
    double least = 4.0;
    for (const PlanePoint& point : *std::ranges::max_element(label.lines, {}, &Polyline::size)) {
      box.centre = share(point);
      const bool is_clear = inside(box) && std::ranges::none_of(taken_, [&](const TextBox& other) {
                              return overlap(box, other);
                            });
      const auto is_crossed = [&](const Polyline& line) { return crosses(box, line); };
      const bool hides = std::ranges::any_of(outlines_, is_crossed) ||
                         std::ranges::any_of(labels_, [&](const Label& other) {
                           return &other != &label && std::ranges::any_of(other.lines, is_crossed);
                         });
      const double off = std::abs(box.centre.x + box.centre.y - 1.0) + (hides ? 2.0 : 0.0);
      if (!is_clear || off >= least) continue;
      least = off;
      best = point;
    }
    if (best) {
      box.centre = share(*best);
      taken_.push_back(box);
    }
    return best;
  }

  GridValues grid_;
  Panel panel_;
  std::vector<Label> labels_;
  std::vector<Polyline> outlines_;
  std::vector<TextBox> taken_;
};

GridValues slip_grid(const Results& results, std::size_t level) {
  const Chart& chart = *results.chart;
  const ChartStatistic design = design_statistic(results);
  GridValues grid{chart.mu, chart.slope_deg, {}};
  for (std::size_t s = 0; s < chart.slope_deg.size(); ++s) {
    for (std::size_t m = 0; m < chart.mu.size(); ++m)
      grid.z.push_back(design.slip_m(chart.at(level, s, m)));
  }
  return grid;
}

/// "largest over buildings of one mass, T 0.2 to 2 s".
std::string building_text(const Results& results) {
  const auto [low, high] = std::ranges::minmax(results.chart->period_s);
  if (high == 0.0) return "rigid building";
  const char* model = results.model.modes.empty() ? "one mass" : "several modes";
  return low == high
             ? fmt::format("building of {}, T {:g} s", model, low)
             : fmt::format("largest over buildings of {}, T {:g} to {:g} s", model, low, high);
}

/// The region where friction cannot hold the array: mu <= tan(slope).
void add_gravity_region(const Chart& chart, ContourPlot& plot) {
  const double least_mu = chart.mu.front(), steepest_deg = chart.slope_deg.back();
  if (std::tan(steepest_deg * rad_per_deg) <= least_mu) return;
  constexpr int steps = 50;
  Polyline edge = {{least_mu, steepest_deg}};
  for (int i = steps; i >= 0; --i) {
    const double slope_deg = steepest_deg * i / steps;
    edge.push_back({std::max(least_mu, std::tan(slope_deg * rad_per_deg)), slope_deg});
  }
  plot.add_outline({DataSeries::Kind::area, look(Role::largest), "slides freely",
                    "slides freely: friction cannot stop the array, tan(slope) >= mu"},
                   edge);
}

/// A standard's limits, as far as they are on the chart.
void add_limits(const Chart& chart, Standard standard, ContourPlot& plot) {
  const double right = chart.mu.back(), bottom = chart.slope_deg.front();
  const double left = std::max(friction_limit(standard), chart.mu.front());
  const double top = std::min(slope_limit_deg(standard), chart.slope_deg.back());
  if (left >= right || top < bottom) return;
  Look line = look(Role::bound);
  if (standard == Standard::asce7_16) line.dash = 4;
  plot.add_outline({DataSeries::Kind::line, line, standard_name(standard) + " limits",
                    standard_name(standard) + " is for slopes below and friction right of this "
                                              "line"},
                   Polyline{{left, bottom}, {left, top}, {right, top}});
}

/// Where no line of a prescribed value crosses the chart.
std::string everywhere(const GridValues& grid, const PrescribedLine& line) {
  return fmt::format(" {} is {} wherever the array does not slide freely.", line.label(),
                     largest(grid.z) < line.value_m ? "more than the chart requires"
                                                    : "less than the chart requires");
}

}  // namespace

Figure chart_contours_figure(const Results& results) {
  const Chart& chart = *results.chart;
  const std::size_t level = nearest(results.levels, chart.shown_level);
  const bool one_record = is_one_record(results);
  Figure figure{
      "chart_contours", shown_title(results) + ", by friction and roof slope",
      at_intensity(results, results.levels[level]) + "; " + results.suites.front().name + "; " +
          building_text(results),
      (one_record ? "Lines of equal peak slip"
                  : "Lines of equal " + design_name(results) + ", " + clearance_rule(results)) +
          "; what linear interpolation in tables/chart.csv gives, and of the inverses beside the "
          "grey "
          "region. Find the coefficient of friction "
          "below and the slope at the left: the line through that point is the " +
          (one_record ? "slip" : design_name(results)) +
          "; or follow a line to the friction that a slope needs. Grey: friction cannot stop the "
          "array. " +
          how_counted(results)};
  const GridValues grid = slip_grid(results, level);
  ContourPlot plot(grid);
  add_gravity_region(chart, plot);
  for (const Standard standard : standards_of(chart)) add_limits(chart, standard, plot);
  for (const PrescribedLine& line : prescribed_at(chart, results.levels[level])) {
    Look thick = prescribed_look(line);
    thick.width = 4.5;
    const bool crosses =
        plot.add("prescribed " + line.names(), line.value_m, short_length(line.value_m), thick,
                 "prescribed by " + line.names());
    figure.caption +=
        crosses ? " Thick: where the chart requires what is prescribed, " + line.label() + "."
                : everywhere(grid, line);
  }
  bool any = false;
  const bool si = LengthUnits::first() == UnitSystem::si;
  const std::vector<double> values = contour_values(grid);
  const char* unit = si ? "m" : "in";
  for (std::size_t i = 0; i < values.size(); ++i) {
    Look line = family_look(i, values.size());
    line.width = 2.0;
    const std::string text = fmt::format("{:g} {}", values[i], unit);
    any |= plot.add("contour " + text, values[i] * (si ? 1.0 : inch_m), text, line);
  }
  if (!any) figure.caption += " No round value crosses the chart: see chart.csv.";
  figure.panels = {plot.labelled()};
  figure.plot_height_px = chart_height_px;
  return figure;
}

}  // namespace glissade
