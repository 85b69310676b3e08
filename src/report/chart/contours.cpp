// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "chart/contour_lines.hpp"
#include "chart/report.hpp"
#include "chart/view.hpp"
#include "figure_text.hpp"
#include "glissade/core/units.hpp"
#include "glissade/report/format.hpp"
#include "gnuplot.hpp"

namespace glissade {
namespace {

constexpr std::array<double, 9> round_values_m = {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0};
constexpr auto standard_colour = "#d55e00";

/// Where text stands, as shares of the plot's width and height.
struct TextBox {
  PlanePoint centre;
  double width = 0.0, height = 0.0;
};

TextBox text_box(const std::string& text) {
  constexpr double character = 0.0108, margin = 0.015, line = 0.055;
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

/// What is drawn: the plot grows by lines and labels that keep clear of each other.
class ContourPlot {
 public:
  explicit ContourPlot(GridValues grid) : grid_(std::move(grid)) {}

  /// Lines at a value with their label, and whether there are any.
  bool add(const std::string& block, double value_m, const std::string& text,
           const std::string& colour, double line_width) {
    const std::vector<Polyline> lines = contour_lines(grid_, value_m);
    if (lines.empty()) return false;
    data_.begin(block, "mu slope_deg");
    for (const Polyline& line : lines) {
      for (const PlanePoint& point : line) data_.row({point.x, point.y});
      data_.break_line();
    }
    elements_.push_back(fmt::format("index '{}' using 1:2 with lines lw {} lc rgb '{}'", block,
                                    line_width, colour));
    if (const auto place = place_of_label(lines, text)) add_label(*place, text, colour, "center");
    return true;
  }

  /// A line or an area of the reader's map that is no contour.
  void add_outline(const std::string& block, const std::string& style, const Polyline& points) {
    data_.begin(block, "mu slope_deg");
    for (const PlanePoint& point : points) data_.row({point.x, point.y});
    elements_.push_back(fmt::format("index '{}' using 1:2 with {}", block, style));
  }

  /// Text at a fixed place: its right end, or where `alignment` says.
  void add_text(const PlanePoint& at, const std::string& text, const std::string& alignment) {
    TextBox box = text_box(text);
    box.centre = share(at);
    const double side = alignment == "right" ? -0.5 : alignment == "left" ? 0.5 : 0.0;
    box.centre.x += side * box.width;
    taken_.push_back(box);
    add_label(at, text, "#444444", alignment);
  }

  /// A line of the key below the plot.
  void add_to_key(const std::string& style, const std::string& text) {
    key_.push_back(fmt::format("keyentry with {} title {}", style, gnuplot::quoted(text)));
  }
  int key_rows() const { return static_cast<int>(key_.size()); }

  std::string body(const FileName& name) const {
    std::string plot = "  NaN";  // axes, even where nothing can be drawn
    for (const std::string& element : elements_)
      plot += ", \\\n  " + quoted_file(name) + " " + element;
    for (const std::string& entry : key_) plot += ", \\\n  " + entry;
    return fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", grid_.x.front(), grid_.x.back(),
                       grid_.y.front(), grid_.y.back()) +
           "set style textbox opaque noborder margins 0.4,0.2\n" + labels_ + "plot \\\n" + plot +
           "\n";
  }
  std::string data() const { return data_.text(); }

 private:
  PlanePoint share(const PlanePoint& p) const {
    return {(p.x - grid_.x.front()) / (grid_.x.back() - grid_.x.front()),
            (p.y - grid_.y.front()) / (grid_.y.back() - grid_.y.front())};
  }

  /// On the longest line, clear of other text, as near as can be to the falling diagonal, which all
  /// lines cross: slip grows with slope and falls with friction.
  std::optional<PlanePoint> place_of_label(const std::vector<Polyline>& lines,
                                           const std::string& text) {
    TextBox box = text_box(text);
    std::optional<PlanePoint> best;
    double least = 2.0;
    const Polyline& longest =
        *std::max_element(lines.begin(), lines.end(),
                          [](const Polyline& a, const Polyline& b) { return a.size() < b.size(); });
    for (const PlanePoint& point : longest) {
      box.centre = share(point);
      const double off = std::abs(box.centre.x + box.centre.y - 1.0);
      const bool clear = inside(box) && std::none_of(taken_.begin(), taken_.end(),
                                                     [&](auto& b) { return overlap(box, b); });
      if (!clear || off >= least) continue;
      least = off;
      best = point;
    }
    if (best) {
      box.centre = share(*best);
      taken_.push_back(box);
    }
    return best;
  }

  void add_label(const PlanePoint& at, const std::string& text, const std::string& colour,
                 const std::string& alignment) {
    labels_ += fmt::format("set label {} at {},{} {} front boxed textcolor rgb '{}'\n",
                           gnuplot::quoted(text), at.x, at.y, alignment, colour);
  }

  GridValues grid_;
  gnuplot::DataBlocks data_;
  std::vector<TextBox> taken_;
  std::vector<std::string> elements_, key_;
  std::string labels_;
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
  const std::string style = "filledcurves closed fs solid 0.35 fc rgb '#777777'";
  plot.add_to_key("filledcurves fs solid 0.35 fc rgb '#777777'",
                  "slides freely: friction cannot stop the array, tan(slope) >= mu");
  plot.add_outline("slides freely", style, edge);
}

/// SEAOC PV1-2012's limits, as far as they lie on the chart.
void add_seaoc_limits(const Chart& chart, ContourPlot& plot) {
  const double right = chart.mu.back(), left = std::max(seaoc_mu_limit, chart.mu.front());
  const double top = std::min(seaoc_slope_limit_deg, chart.slope_deg.back());
  if (left >= right) return;
  plot.add_outline("SEAOC limits", "lines dt 2 lw 1.5 lc rgb '#444444'",
                   {{left, chart.slope_deg.front()}, {left, top}, {right, top}});
  const double line_deg = 0.04 * (chart.slope_deg.back() - chart.slope_deg.front());
  plot.add_text({right, top - line_deg}, "SEAOC PV1-2012 is for slopes and friction in here",
                "right");
}

/// What a reader is told where no line of a prescribed value crosses the chart.
std::string everywhere(const GridValues& grid, const PrescribedLine& line) {
  double largest = 0.0;
  for (const double slip_m : grid.z) {
    if (std::isfinite(slip_m)) largest = std::max(largest, slip_m);
  }
  return fmt::format(
      " {} is {} wherever the array does not slide freely.", line.label(),
      largest < line.value_m ? "more than the chart asks for" : "less than the chart asks for");
}

}  // namespace

Figure chart_contours_figure(const Results& results) {
  const Chart& chart = *results.chart;
  const std::size_t level = nearest(results.levels, chart.shown_level);
  const bool one_record = is_one_record(results);
  Figure figure;
  figure.name = "chart_contours";
  figure.title = one_record ? "Peak slip over friction and roof slope"
                            : "Clearance to provide, over friction and roof slope";
  figure.caption =
      std::string(one_record ? "Lines of equal peak slip"
                             : "Lines of equal clearance, 1.1 x the mean over the records (Walters "
                               "et al. 2012)") +
      "; what linear interpolation in tables/chart.csv gives. Find the coefficient of friction "
      "below and the slope at the left: the line through that point is the " +
      (one_record ? "slip" : "clearance") +
      "; or follow a line to the friction that a slope needs. Grey: friction cannot stop the "
      "array. " +
      how_counted(results);
  const GridValues grid = slip_grid(results, level);
  ContourPlot plot(grid);
  add_gravity_region(chart, plot);
  const std::vector<Standard> standards = standards_of(chart);
  if (std::count(standards.begin(), standards.end(), Standard::seaoc_pv1_2012) > 0)
    add_seaoc_limits(chart, plot);
  for (const PrescribedLine& line : prescribed_at(chart, results.levels[level])) {
    const std::string text = line.names() + ": " + format_number(line.value_m) + " m";
    if (plot.add("prescribed " + line.names(), line.value_m, text, standard_colour, 4.0))
      figure.caption +=
          " Thick: where the chart asks for what is prescribed, " + line.label() + ".";
    else
      figure.caption += everywhere(grid, line);
  }
  bool any = false;
  for (std::size_t i = 0; i < round_values_m.size(); ++i) {
    const double value_m = round_values_m[i];
    any |= plot.add(fmt::format("contour {} m", value_m), value_m, fmt::format("{} m", value_m),
                    gnuplot::ramp_colour(i, round_values_m.size()), 2.0);
  }
  if (!any) {
    figure.caption += fmt::format(" No line from {} to {} m crosses the chart: see chart.csv.",
                                  round_values_m.front(), round_values_m.back());
  }
  figure.body = title_of(figure, at_intensity(results, results.levels[level])) +
                axis("x", "Coefficient of friction") + axis("y", "Roof slope (degrees)") +
                plot.body(figure.name);
  figure.key_rows = plot.key_rows();
  figure.data = plot.data();
  return figure;
}

}  // namespace glissade
