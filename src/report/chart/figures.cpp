// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "chart/curves.hpp"
#include "chart/report.hpp"
#include "chart/view.hpp"
#include "figure_text.hpp"
#include "glissade/report/format.hpp"
#include "gnuplot.hpp"

namespace glissade {
namespace {

constexpr auto slope_label = "Roof slope (degrees)";
/// What the dashed lines are; "" where there are none.
std::string prescribed_note(const Results& results) {
  return results.chart->standards.empty()
             ? ""
             : " Dashed: prescribed; SEAOC PV1-2012 is for " + seaoc_limits() + ".";
}

constexpr auto gaps =
    " Gaps and missing ends: friction cannot stop the array. Curves may leave at the top; "
    "every number is in tables/chart.csv.";

/// What is drawn where there is one curve for each of several: "clearance" or "peak slip".
std::string what_is_read(const Results& results) {
  return is_one_record(results) ? "peak slip" : "clearance";
}

std::string y_label(const Results& results) {
  return is_one_record(results) ? "Peak slip in plan" : "Clearance, 1.1 x mean slip in plan";
}

/// The places of what is shown on the chart's axes.
struct Shown {
  std::size_t level, slope, friction;
};
Shown shown_place(const Results& results) {
  const Chart& chart = *results.chart;
  return {nearest(results.levels, chart.shown_level),
          nearest(chart.slope_deg, chart.shown_slope_deg), nearest(chart.mu, chart.shown_mu)};
}

std::string friction_text(double mu) { return "friction " + brief(mu); }

/// Each statistic at a row of points: the one to design with thick, the others thin.
std::vector<Curve> statistic_curves(const Results& results,
                                    const std::vector<const ChartPoint*>& points) {
  static constexpr const char* styles[] = {
      "linespoints lw 4 pt 7 ps 0.5 lc rgb '#0072b2'", "lines lw 2 dt 3 lc rgb '#0072b2'",
      "lines lw 2 lc rgb '#009e73'", "lines lw 2 dt 2 lc rgb '#cc79a7'",
      "lines lw 2 dt 4 lc rgb '#777777'"};
  std::vector<Curve> curves;
  for (const ChartStatistic& statistic : chart_statistics(results)) {
    Curve curve{statistic.heading, styles[curves.size()], {}};
    for (const ChartPoint* point : points) curve.y_m.push_back(statistic.slip_m(*point));
    curves.push_back(std::move(curve));
  }
  return curves;
}

std::string caption_of(const Results& results, const std::string& reading) {
  return reading + " " + how_counted(results) + gaps;
}

}  // namespace

Figure chart_slope_figure(const Results& results) {
  const Chart& chart = *results.chart;
  const Shown shown = shown_place(results);
  const double mu = chart.mu[shown.friction], level = results.levels[shown.level];
  Figure figure;
  figure.name = "chart_slope";
  figure.title = "Slip over the slope of the roof";
  CurvePlot plot{.x_label = slope_label, .x_column = "slope_deg", .x = chart.slope_deg};
  plot.y_label = "Displacement in plan";
  std::vector<const ChartPoint*> points;
  for (std::size_t s = 0; s < chart.slope_deg.size(); ++s)
    points.push_back(&chart.at(shown.level, s, shown.friction));
  plot.curves = statistic_curves(results, points);
  plot.key_columns = plot.curves.size() > 1 ? 3 : 1;
  std::string out_of_range;
  for (const PrescribedLine& line : prescribed_at(chart, level)) {
    if (mu > line.mu_limit()) {
      plot.horizontals.push_back(
          {line, {plot.x.front(), std::min(line.slope_limit_deg(), plot.x.back())}});
    } else {
      out_of_range = fmt::format(" {} is not drawn: it is for friction above {}.", line.label(),
                                 line.mu_limit());
    }
  }
  figure.caption =
      caption_of(results,
                 is_one_record(results)
                     ? "Peak slip at each slope."
                     : "Thick: the clearance to provide, 1.1 x the mean over the records (Walters "
                       "et al. 2012); thin: the mean itself, percentiles over the records, and the "
                       "largest record.") +
      prescribed_note(results) + out_of_range;
  draw_curves(figure, at_intensity(results, level) + "; " + friction_text(mu), plot);
  return figure;
}

Figure chart_friction_figure(const Results& results) {
  constexpr std::size_t most_curves = 6;
  const Chart& chart = *results.chart;
  const Shown shown = shown_place(results);
  const double level = results.levels[shown.level];
  Figure figure;
  figure.name = "chart_friction";
  figure.title = is_one_record(results) ? "Peak slip over friction, by roof slope"
                                        : "Clearance to provide, over friction and roof slope";
  CurvePlot plot{.x_label = "Coefficient of friction", .x_column = "mu", .x = chart.mu};
  plot.y_label = y_label(results);
  plot.key_columns = 3;
  plot.share_within = 0.8;
  const std::vector<std::size_t> slopes = spread(chart.slope_deg.size(), most_curves);
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    Curve curve{"slope " + degrees(chart.slope_deg[slopes[i]]), family_style(i, slopes.size()), {}};
    for (std::size_t m = 0; m < chart.mu.size(); ++m) {
      curve.y_m.push_back(design_statistic(results).slip_m(chart.at(shown.level, slopes[i], m)));
    }
    plot.curves.push_back(std::move(curve));
  }
  for (const PrescribedLine& line : prescribed_at(chart, level)) {
    const double from = std::max(line.mu_limit(), plot.x.front());
    if (from < plot.x.back()) plot.horizontals.push_back({line, {from, plot.x.back()}});
  }
  figure.caption = caption_of(results,
                              "Read up from the coefficient of friction to the curve of "
                              "the roof's slope, then left (m) or right (in): the " +
                                  what_is_read(results) + ".") +
                   prescribed_note(results);
  draw_curves(figure, at_intensity(results, level), plot);
  return figure;
}

Figure chart_intensity_figure(const Results& results) {
  constexpr std::size_t most_curves = 8;
  const Chart& chart = *results.chart;
  const Shown shown = shown_place(results);
  Figure figure;
  figure.name = "chart_intensity";
  figure.title = "Slip as the shaking grows, by friction";
  CurvePlot plot{.x_label = results.intensity_label, .x_column = "level_g", .x = results.levels};
  plot.y_label = y_label(results);
  plot.key_columns = 4;
  plot.share_within = 0.88;
  const std::vector<std::size_t> frictions = spread(chart.mu.size(), most_curves);
  for (std::size_t i = 0; i < frictions.size(); ++i) {
    Curve curve{friction_text(chart.mu[frictions[i]]), family_style(i, frictions.size()), {}};
    for (std::size_t l = 0; l < results.levels.size(); ++l) {
      curve.y_m.push_back(design_statistic(results).slip_m(chart.at(l, shown.slope, frictions[i])));
    }
    plot.curves.push_back(std::move(curve));
  }
  figure.caption =
      caption_of(results, "The " + what_is_read(results) +
                              " over intensity, a curve for each coefficient of "
                              "friction: none up to a level that grows with friction.");
  draw_curves(figure, "slope " + degrees(chart.slope_deg[shown.slope]), plot);
  return figure;
}

Figure chart_slope_levels_figure(const Results& results) {
  constexpr std::size_t most_curves = 8;
  const Chart& chart = *results.chart;
  const Shown shown = shown_place(results);
  Figure figure;
  figure.name = "chart_slope_levels";
  figure.title = "Slip over the slope of the roof, by intensity";
  CurvePlot plot{.x_label = slope_label, .x_column = "slope_deg", .x = chart.slope_deg};
  plot.y_label = y_label(results);
  plot.key_columns = 4;
  const std::vector<std::size_t> levels = spread(results.levels.size(), most_curves);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    Curve curve{brief(results.levels[levels[i]]) + " g", family_style(i, levels.size()), {}};
    for (std::size_t s = 0; s < chart.slope_deg.size(); ++s) {
      curve.y_m.push_back(design_statistic(results).slip_m(chart.at(levels[i], s, shown.friction)));
    }
    plot.curves.push_back(std::move(curve));
  }
  figure.caption = caption_of(results, "The " + what_is_read(results) +
                                           " over slope, a curve for each level of intensity.");
  draw_curves(
      figure,
      friction_text(chart.mu[shown.friction]) + "; a curve per level, " + results.intensity_label,
      plot);
  return figure;
}

Figure chart_period_figure(const Results& results) {
  const Chart& chart = *results.chart;
  const Shown shown = shown_place(results);
  const ChartPoint& point = shown_point(results);
  Figure figure;
  figure.name = "chart_period";
  figure.title = "Slip over the period of the building";
  CurvePlot plot{.x_label = "Building period (s)", .x_column = "period_s", .x = chart.period_s};
  plot.y_label = "Displacement in plan";
  plot.key_columns = 3;
  struct Part {
    const char *title, *style;
    double ChartSlip::*slip_m;
  };
  const Part largest = {"Largest record", "linespoints lw 2 dt 4 pt 13 ps 0.7 lc rgb '#777777'",
                        &ChartSlip::envelope_m};
  std::vector<Part> parts = {
      {"Mean over records", "linespoints lw 2.5 pt 7 ps 0.7 lc rgb '#0072b2'", &ChartSlip::mean_m},
      {"84th percentile", "linespoints lw 2 pt 5 ps 0.7 lc rgb '#009e73'", &ChartSlip::p84_m},
      {"95th percentile", "linespoints lw 2 dt 2 pt 9 ps 0.7 lc rgb '#cc79a7'", &ChartSlip::p95_m},
      largest};
  if (is_one_record(results)) parts = {largest};
  for (const Part& part : parts) {
    Curve curve{part.title, part.style, {}};
    for (const ChartSlip& slip : point.by_period) curve.y_m.push_back(slip.*part.slip_m);
    plot.curves.push_back(std::move(curve));
  }
  const ChartStatistic design = design_statistic(results);
  plot.curves.push_back({is_one_record(results) ? "Largest over periods" : design.heading,
                         "lines lw 4 lc rgb '#0072b2'",
                         std::vector<double>(chart.period_s.size(), design.slip_m(point))});
  for (const PrescribedLine& line : prescribed_at(chart, point.level)) {
    if (std::none_of(line.standards.begin(), line.standards.end(), [&](Standard standard) {
          return applies_at(standard, point.slope_deg, point.mu);
        }))
      continue;
    plot.horizontals.push_back({line, {plot.x.front(), plot.x.back()}});
  }
  figure.caption =
      caption_of(results,
                 is_one_record(results)
                     ? "Peak slip by building period; thick: the largest, which the chart shows."
                     : "Slip by building period. Thick: the clearance, 1.1 x the mean at the worst "
                       "period.") +
      prescribed_note(results);
  draw_curves(figure,
              fmt::format("{}; slope {}; {}", at_intensity(results, results.levels[shown.level]),
                          degrees(point.slope_deg), friction_text(point.mu)),
              plot);
  return figure;
}

std::vector<Figure> chart_figures(const Results& results) {
  std::vector<Figure> figures;
  // Of slopes below 0 and 0 alone, one is left.
  if (results.chart->slope_deg.size() > 1) figures.push_back(chart_contours_figure(results));
  figures.push_back(chart_friction_figure(results));
  figures.push_back(chart_slope_figure(results));
  if (results.levels.size() > 1) {
    figures.push_back(chart_intensity_figure(results));
    figures.push_back(chart_slope_levels_figure(results));
  }
  if (results.chart->period_s.size() > 1) figures.push_back(chart_period_figure(results));
  if (!results.suites.front().spectra.periods_s.empty()) figures.push_back(spectra_figure(results));
  return figures;
}

}  // namespace glissade
