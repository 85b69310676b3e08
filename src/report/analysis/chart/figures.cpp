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
constexpr std::size_t most_curves = 4;

/// The places of what is shown on the chart's axes.
struct Shown {
  std::size_t level, slope, friction;
};
Shown shown_place(const Results& results) {
  const Chart& chart = *results.chart;
  return {nearest(results.levels, chart.shown_level),
          nearest(chart.slope_deg, chart.shown_slope_deg), nearest(chart.mu, chart.shown_mu)};
}

std::string suite_text(const Results& results) { return results.suites.front().name + "; "; }

std::string friction_text(double mu) { return "friction " + brief(mu); }

std::string y_label(const Results& results) {
  const std::string name = design_name(results);
  return name == "chart clearance"
             ? fmt::format("Chart clearance, {:g} x mean slip in plan", clearance_factor(results))
             : design_title(results) + " in plan";
}

std::string caption_of(const Results& results, const std::string& reading) {
  std::string limits;
  for (const Standard standard : standards_of(*results.chart))
    limits += fmt::format("{}{} is for {}", limits.empty() ? "" : "; ", standard_name(standard),
                          limits_of(standard));
  return reading + " " + how_counted(results) +
         " Gaps and missing ends: above the figure, or friction cannot stop the array; every "
         "number is in tables/chart.csv." +
         (limits.empty() ? ""
                         : " Broken lines, thin towards their labels: prescribed; " + limits + ".");
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

/// Ends the curves where slips would press the others flat.
void drop_high_slips(CurvePlot& plot) {
  std::vector<double> slips;
  for (const DataSeries& curve : plot.curves)
    std::ranges::copy_if(curve.y, std::back_inserter(slips),
                         [](double slip_m) { return std::isfinite(slip_m) && slip_m > 0.0; });
  if (slips.empty()) return;
  const double limit_m = 2.0 * quantile_of(slips, plot.share_within);
  for (DataSeries& curve : plot.curves)
    for (double& slip_m : curve.y)
      if (slip_m > limit_m) slip_m = std::nan("");
}

/// The height of the figure: with the prescribed values where they do not press the curves flat.
double top_m(const CurvePlot& plot) {
  double curves_m = 0.0;
  for (const DataSeries& curve : plot.curves) curves_m = std::max(curves_m, largest(curve.y));
  if (curves_m == 0.0) curves_m = 1.0;
  double top = curves_m;
  for (const auto& [line, where] : plot.prescribed)
    if (line.value_m < 3.0 * curves_m) top = std::max(top, line.value_m);
  return 1.08 * top;
}

/// "SEAOC PV1-2012: 21.6 in (recalled)"
std::string rule_label(const PrescribedLine& line, double top) {
  return line.names() + ": " + short_length(line.value_m) +
         (line.provenance == Provenance::recalled ? " (recalled)" : "") +
         (line.value_m > top ? ", above the figure" : "");
}

std::vector<Panel> drawn(CurvePlot plot) {
  drop_high_slips(plot);
  const double top = top_m(plot);
  Panel panel{"",
              {plot.x_label, plot.x.front(), plot.x.back()},
              length_axis(plot.y_label, top),
              plot.curves};
  for (const auto& [line, where] : plot.prescribed) {
    panel.rules.push_back({Rule::Kind::horizontal, line.value_m, prescribed_look(line),
                           rule_label(line, top), where.from, where.to});
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
  static constexpr Role roles[] = {Role::clearance, Role::p84, Role::p95, Role::largest};
  for (const ChartStatistic& statistic : chart_statistics(results)) {
    if (statistic.stem == "mean_slip") continue;  // a part of the clearance
    std::vector<double> y_m;
    for (std::size_t s = 0; s < chart.slope_deg.size(); ++s)
      y_m.push_back(statistic.slip_m(chart.at(shown.level, s, shown.friction)));
    const Role role = roles[plot.curves.size()];
    plot.add(statistic.name, look(role),
             role == Role::clearance ? with_points : DataSeries::Kind::line, std::move(y_m));
  }
  std::string out_of_range;
  for (const PrescribedLine& line : prescribed_at(chart, level)) {
    if (mu >= line.mu_limit()) {
      plot.prescribed.push_back(
          {line, {plot.x.front(), std::min(line.slope_limit(), plot.x.back())}});
    } else {
      out_of_range = fmt::format(" {} is not drawn: it is for friction of {} or more.",
                                 line.label(), line.mu_limit());
    }
  }
  const std::string reading = is_one_record(results) ? "Peak slip at each slope."
                                                     : "Thick: the " + design_name(results) + ", " +
                                                           clearance_rule(results) +
                                                           "; thin: percentiles, and the largest.";
  return {"chart_slope", "Slip over the slope of the roof",
          suite_text(results) + at_intensity(results, level) + "; " + friction_text(mu),
          caption_of(results, reading) + out_of_range, drawn(plot)};
}

Figure chart_friction_figure(const Results& results) {
  const Chart& chart = *results.chart;
  const Shown shown = shown_place(results);
  const double level = results.levels[shown.level];
  CurvePlot plot{y_label(results), "Coefficient of friction", chart.mu, 0.8};
  add_members(
      results, spread(chart.slope_deg.size(), most_curves),
      [&](std::size_t s) { return "slope " + degrees(chart.slope_deg[s]); },
      [&](std::size_t s, std::size_t m) -> const ChartPoint& {
        return chart.at(shown.level, s, m);
      },
      plot);
  std::string slopes;  // that the prescribed values are for
  for (const PrescribedLine& line : prescribed_at(chart, level)) {
    const double from = std::max(line.mu_limit(), plot.x.front());
    if (from >= plot.x.back()) continue;
    plot.prescribed.push_back({line, {from, plot.x.back()}});
    slopes += fmt::format("{}{} to {:.3g}", slopes.empty() ? "; " : ", ", line.names(),
                          line.slope_limit());
  }
  if (!slopes.empty()) slopes += " degrees";
  return {"chart_friction",
          is_one_record(results) ? "Peak slip over friction, by roof slope"
                                 : design_title(results) + " over friction, by roof slope",
          suite_text(results) + at_intensity(results, level) + slopes,
          caption_of(results,
                     "Read up from the coefficient of friction to the curve of the roof's "
                     "slope, then left: the " +
                         design_name(results) + "." +
                         (plot.curves.size() < chart.slope_deg.size()
                              ? " The slopes between those that are drawn are in the table."
                              : "")),
          drawn(plot)};
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
  return {"chart_intensity", "Slip over intensity, by friction",
          suite_text(results) + "slope " + degrees(chart.slope_deg[shown.slope]),
          caption_of(results, "The " + design_name(results) +
                                  " over intensity, a curve for each coefficient of friction: none "
                                  "up to a level that grows with friction."),
          drawn(plot)};
}

Figure chart_slope_levels_figure(const Results& results) {
  const Chart& chart = *results.chart;
  const Shown shown = shown_place(results);
  CurvePlot plot{y_label(results), slope_label, chart.slope_deg};
  std::vector<std::size_t> levels = spread(results.levels.size(), most_curves + 1);
  if (results.levels.front() == 0.0 || levels.size() > most_curves) levels.erase(levels.begin());
  add_members(
      results, levels, [&](std::size_t l) { return with_unit(results, brief(results.levels[l])); },
      [&](std::size_t l, std::size_t s) -> const ChartPoint& {
        return chart.at(l, s, shown.friction);
      },
      plot);
  return {"chart_slope_levels", "Slip over the slope of the roof, by intensity",
          suite_text(results) + friction_text(chart.mu[shown.friction]) + "; a curve per level, " +
              results.intensity_label,
          caption_of(results, "The " + design_name(results) +
                                  " over slope, a curve for each level of intensity."),
          drawn(plot)};
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
  for (const Part& part : {Part{"mean over records", Role::mean, &ChartSlip::mean_m},
                           Part{"95th percentile", Role::p95, &ChartSlip::p95_m},
                           Part{"largest", Role::largest, &ChartSlip::envelope_m}}) {
    if (one_record && part.role != Role::largest) continue;
    std::vector<double> y_m;
    for (const ChartSlip& slip : point.by_period) y_m.push_back(slip.*part.slip_m);
    plot.add(part.label, look(part.role), with_points, std::move(y_m));
  }
  const ChartStatistic design = design_statistic(results);
  plot.add(one_record ? "largest over periods" : design.name, look(Role::clearance),
           DataSeries::Kind::line,
           std::vector<double>(chart.period_s.size(), design.slip_m(point)));
  for (const PrescribedLine& line : prescribed_at(chart, point.level)) {
    const bool applies = std::ranges::any_of(line.standards, [&](Standard standard) {
      return applies_at(standard, point.slope_deg, point.mu);
    });
    if (applies) plot.prescribed.push_back({line, {plot.x.front(), plot.x.back()}});
  }
  return {"chart_period", "Slip over the period of the building",
          fmt::format("{}{}; slope {}; {}", suite_text(results),
                      at_intensity(results, results.levels[shown.level]), degrees(point.slope_deg),
                      friction_text(point.mu)),
          caption_of(results, one_record
                                  ? "Peak slip by building period; thick: the largest, "
                                    "which the chart shows."
                                  : fmt::format("Slip by building period. Thick: the {}, "
                                                "{:g} x the largest of the means.",
                                                design_name(results), clearance_factor(results))),
          drawn(plot)};
}

}  // namespace

std::vector<Figure> chart_figures(const Results& results) {
  std::vector<Figure> figures;
  // Friction that is drawn is one column of the chart.
  if (results.chart->mu.size() > 1) figures.push_back(chart_friction_figure(results));
  figures.push_back(chart_slope_figure(results));
  if (results.levels.size() > 1) {
    figures.push_back(chart_intensity_figure(results));
    figures.push_back(chart_slope_levels_figure(results));
  }
  if (results.chart->period_s.size() > 1) figures.push_back(chart_period_figure(results));
  for (Figure& figure : figures) {
    figure.labels_at_lines = true;
    figure.plot_height_px = chart_height_px;
  }
  if (results.chart->mu.size() > 1) figures.insert(figures.begin(), chart_contours_figure(results));
  return figures;
}

}  // namespace glissade
