// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/chart/report.hpp"
#include "analysis/chart/view.hpp"
#include "glissade/core/quantile.hpp"
#include "glissade/report/format.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

constexpr auto slope_label = "Roof slope (degrees)";
constexpr std::size_t most_curves = 8;

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

std::string y_label(const Results& results) {
  const std::string name = design_name(results);
  return name == "chart clearance"
             ? fmt::format("Chart clearance, {:g} x mean slip in plan", clearance_factor(results))
             : design_title(results) + " in plan";
}

std::string caption_of(const Results& results, const std::string& reading) {
  return reading + " " + how_counted(results) +
         " Gaps and missing ends: friction cannot stop the array. Curves may leave at the top; "
         "every number is in tables/chart.csv." +
         (results.chart->standards.empty()
              ? ""
              : " Dashed: prescribed; SEAOC PV1-2012 is for " + seaoc_limits() + ".");
}

/// Where on the x axis a prescribed value applies.
struct Stretch {
  double from = 0.0, to = 0.0;
};

/// Slip over something.
struct CurvePlot {
  std::string y_label;
  std::string x_label;
  std::vector<double> x;
  double share_within = 1.0;  ///< of the slips the figure must hold; 1: all
  std::vector<DataSeries> curves = {};
  std::vector<std::pair<PrescribedLine, Stretch>> prescribed = {};

  void add(const std::string& label, Look look, DataSeries::Kind kind, std::vector<double> y_m) {
    curves.push_back({kind, look, label, label, x, std::move(y_m)});
  }
};

/// The height of the figure: without the few slips that would press the others flat, and with the
/// prescribed values where they do not.
double top_m(const CurvePlot& plot) {
  std::vector<double> slips;
  for (const DataSeries& curve : plot.curves)
    std::ranges::copy_if(curve.y, std::back_inserter(slips),
                         [](double slip_m) { return std::isfinite(slip_m) && slip_m > 0.0; });
  const double curves_m =
      slips.empty() ? 1.0 : std::min(largest(slips), 1.5 * quantile_of(slips, plot.share_within));
  double top = curves_m;
  for (const auto& [line, where] : plot.prescribed)
    if (line.value_m < 3.0 * curves_m) top = std::max(top, line.value_m);
  return 1.08 * top;
}

std::vector<Panel> drawn(const CurvePlot& plot) {
  const double top = top_m(plot);
  Panel panel{"",
              {plot.x_label, plot.x.front(), plot.x.back()},
              length_axis(plot.y_label, top),
              plot.curves};
  for (const auto& [line, where] : plot.prescribed) {
    Look style = look(Role::prescribed);
    style.dash = panel.rules.empty() ? 2 : 4;
    panel.rules.push_back({Rule::Kind::horizontal, line.value_m, style,
                           line.label() + (line.value_m > top ? ": above the figure" : ""),
                           where.from, where.to});
  }
  return {panel};
}

constexpr auto with_points = DataSeries::Kind::line_and_points;

/// The number to design with over the plot's x, a curve for each of some `members`:
/// `point(member, i)` is the chart's point at the i-th x.
template <class Label, class Point>
void add_members(const Results& results, const std::vector<std::size_t>& members, Label label,
                 Point point, CurvePlot& plot) {
  const ChartStatistic design = design_statistic(results);
  for (std::size_t m = 0; m < members.size(); ++m) {
    Look look = family_look(m, members.size());
    look.width = 2.0;
    look.symbol_size = 0.6;
    std::vector<double> y_m;
    for (std::size_t i = 0; i < plot.x.size(); ++i)
      y_m.push_back(design.slip_m(point(members[m], i)));
    plot.add(label(members[m]), look, with_points, std::move(y_m));
  }
}

Figure chart_slope_figure(const Results& results) {
  const Chart& chart = *results.chart;
  const Shown shown = shown_place(results);
  const double mu = chart.mu[shown.friction], level = results.levels[shown.level];
  CurvePlot plot{"Displacement in plan", slope_label, chart.slope_deg};
  static constexpr Role roles[] = {Role::clearance, Role::mean, Role::p84, Role::p95,
                                   Role::largest};
  for (const ChartStatistic& statistic : chart_statistics(results)) {
    std::vector<double> y_m;
    for (std::size_t s = 0; s < chart.slope_deg.size(); ++s)
      y_m.push_back(statistic.slip_m(chart.at(shown.level, s, shown.friction)));
    const Role role = roles[plot.curves.size()];
    plot.add(statistic.heading, look(role),
             role == Role::clearance ? with_points : DataSeries::Kind::line, std::move(y_m));
  }
  std::string out_of_range;
  for (const PrescribedLine& line : prescribed_at(chart, level)) {
    if (mu > line.mu_limit()) {
      plot.prescribed.push_back(
          {line, {plot.x.front(), std::min(line.slope_limit_deg(), plot.x.back())}});
    } else {
      out_of_range = fmt::format(" {} is not drawn: it is for friction above {}.", line.label(),
                                 line.mu_limit());
    }
  }
  const std::string reading = is_one_record(results)
                                  ? "Peak slip at each slope."
                                  : "Thick: the " + design_name(results) + ", " +
                                        clearance_rule(results) +
                                        "; thin: the mean itself, percentiles, and the largest.";
  return {"chart_slope",
          "Slip over the slope of the roof",
          at_intensity(results, level) + "; " + friction_text(mu),
          caption_of(results, reading) + out_of_range,
          drawn(plot),
          plot.curves.size() > 1 ? 2 : 1};
}

Figure chart_friction_figure(const Results& results) {
  const Chart& chart = *results.chart;
  const Shown shown = shown_place(results);
  const double level = results.levels[shown.level];
  CurvePlot plot{y_label(results), "Coefficient of friction", chart.mu, 0.8};
  add_members(
      results, spread(chart.slope_deg.size(), 6),
      [&](std::size_t s) { return "slope " + degrees(chart.slope_deg[s]); },
      [&](std::size_t s, std::size_t m) -> const ChartPoint& {
        return chart.at(shown.level, s, m);
      },
      plot);
  for (const PrescribedLine& line : prescribed_at(chart, level)) {
    const double from = std::max(line.mu_limit(), plot.x.front());
    if (from < plot.x.back()) plot.prescribed.push_back({line, {from, plot.x.back()}});
  }
  return {"chart_friction",
          is_one_record(results) ? "Peak slip over friction, by roof slope"
                                 : design_title(results) + " over friction and roof slope",
          at_intensity(results, level),
          caption_of(results,
                     "Read up from the coefficient of friction to the curve of the roof's "
                     "slope, then left: the " +
                         design_name(results) + "."),
          drawn(plot),
          2};
}

Figure chart_intensity_figure(const Results& results) {
  const Chart& chart = *results.chart;
  const Shown shown = shown_place(results);
  CurvePlot plot{y_label(results), results.intensity_label, results.levels, 0.88};
  add_members(
      results, spread(chart.mu.size(), most_curves),
      [&](std::size_t m) { return friction_text(chart.mu[m]); },
      [&](std::size_t m, std::size_t l) -> const ChartPoint& {
        return chart.at(l, shown.slope, m);
      },
      plot);
  return {"chart_intensity",
          "Slip over intensity, by friction",
          "slope " + degrees(chart.slope_deg[shown.slope]),
          caption_of(results, "The " + design_name(results) +
                                  " over intensity, a curve for each coefficient of friction: none "
                                  "up to a level that grows with friction."),
          drawn(plot),
          4};
}

Figure chart_slope_levels_figure(const Results& results) {
  const Chart& chart = *results.chart;
  const Shown shown = shown_place(results);
  CurvePlot plot{y_label(results), slope_label, chart.slope_deg};
  add_members(
      results, spread(results.levels.size(), most_curves),
      [&](std::size_t l) { return with_unit(results, brief(results.levels[l])); },
      [&](std::size_t l, std::size_t s) -> const ChartPoint& {
        return chart.at(l, s, shown.friction);
      },
      plot);
  return {
      "chart_slope_levels",
      "Slip over the slope of the roof, by intensity",
      friction_text(chart.mu[shown.friction]) + "; a curve per level, " + results.intensity_label,
      caption_of(results, "The " + design_name(results) +
                              " over slope, a curve for each level of intensity."),
      drawn(plot),
      4};
}

Figure chart_period_figure(const Results& results) {
  const Chart& chart = *results.chart;
  const Shown shown = shown_place(results);
  const ChartPoint& point = shown_point(results);
  const bool one_record = is_one_record(results);
  CurvePlot plot{"Displacement in plan", "Building period (s)", chart.period_s};
  struct Part {
    const char* label;
    Role role;
    double ChartSlip::*slip_m;
  };
  for (const Part& part : {Part{"Mean over records", Role::mean, &ChartSlip::mean_m},
                           Part{"84th percentile", Role::p84, &ChartSlip::p84_m},
                           Part{"95th percentile", Role::p95, &ChartSlip::p95_m},
                           Part{"Largest", Role::largest, &ChartSlip::envelope_m}}) {
    if (one_record && part.role != Role::largest) continue;
    std::vector<double> y_m;
    for (const ChartSlip& slip : point.by_period) y_m.push_back(slip.*part.slip_m);
    plot.add(part.label, look(part.role), with_points, std::move(y_m));
  }
  const ChartStatistic design = design_statistic(results);
  plot.add(one_record ? "Largest over periods" : design.heading, look(Role::clearance),
           DataSeries::Kind::line,
           std::vector<double>(chart.period_s.size(), design.slip_m(point)));
  for (const PrescribedLine& line : prescribed_at(chart, point.level)) {
    const bool applies = std::ranges::any_of(line.standards, [&](Standard standard) {
      return applies_at(standard, point.slope_deg, point.mu);
    });
    if (applies) plot.prescribed.push_back({line, {plot.x.front(), plot.x.back()}});
  }
  return {"chart_period",
          "Slip over the period of the building",
          fmt::format("{}; slope {}; {}", at_intensity(results, results.levels[shown.level]),
                      degrees(point.slope_deg), friction_text(point.mu)),
          caption_of(results, one_record
                                  ? "Peak slip by building period; thick: the largest, "
                                    "which the chart shows."
                                  : fmt::format("Slip by building period. Thick: the {}, "
                                                "{:g} x the largest of the means.",
                                                design_name(results), clearance_factor(results))),
          drawn(plot),
          2};
}

}  // namespace

std::vector<Figure> chart_figures(const Results& results) {
  std::vector<Figure> figures;
  // Friction that is drawn is one column of the chart.
  if (results.chart->mu.size() > 1) {
    figures.push_back(chart_contours_figure(results));
    figures.push_back(chart_friction_figure(results));
  }
  figures.push_back(chart_slope_figure(results));
  if (results.levels.size() > 1) {
    figures.push_back(chart_intensity_figure(results));
    figures.push_back(chart_slope_levels_figure(results));
  }
  if (results.chart->period_s.size() > 1) figures.push_back(chart_period_figure(results));
  return figures;
}

}  // namespace glissade
