// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/chart/report.hpp"
#include "analysis/chart/view.hpp"
#include "glissade/core/quantile.hpp"
#include "glissade/report/format.hpp"
#include "plot/view.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

constexpr auto slope_label = "Roof slope (degrees)";
constexpr std::size_t most_curves = 4;

std::string suite_text(const Results& results) { return results.suites.front().name + "; "; }

std::string friction_text(double mu) { return "friction " + brief(mu); }

std::string y_label(const Results& results) {
  return (is_one_record(results) ? design_title(results) : shown_title(results)) + " in plan";
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

/// Of the chart's axes but two what is shown.
Where shown_but(const Results& results, const std::string& x, const std::string& group = "") {
  const ChartPoint& shown = shown_point(results);
  Where where{{"level", shown.level}, {"slope", shown.slope_deg}, {"mu", shown.mu}};
  std::erase_if(where, [&](const auto& of) { return of.first == x || of.first == group; });
  return where;
}

/// The number to design with, a line for each of some values of a column.
std::vector<ViewLine> lines_by(const Results& results, const std::string& group,
                               const std::vector<double>& values,
                               const std::vector<std::size_t>& drawn,
                               std::string (*label)(const Results&, double)) {
  std::vector<ViewLine> lines;
  for (const std::size_t i : drawn) {
    Look look = family_look(lines.size(), drawn.size());
    look.width = 2.0;
    look.symbol_size = 0.6;
    lines.push_back({label(results, values[i]),
                     look,
                     as_line_and_points,
                     design_statistic(results).stem,
                     {{group, values[i]}}});
  }
  return lines;
}

/// A prescribed value, and where on the x axis it applies.
struct Stretch {
  PrescribedLine line;
  double from, to;
};

/// Ends the lines where they would press the others flat: at twice the slips that this share does
/// not exceed.
void drop_high_slips(Panel& panel, double share_within) {
  std::vector<double> slips;
  for (const DataSeries& line : panel.series)
    std::ranges::copy_if(line.y, std::back_inserter(slips),
                         [](double slip_m) { return std::isfinite(slip_m) && slip_m > 0.0; });
  if (slips.empty()) return;
  const double limit_m = 2.0 * quantile_of(slips, share_within);
  for (DataSeries& line : panel.series)
    for (double& slip_m : line.y)
      if (slip_m > limit_m) slip_m = std::nan("");
}

/// Slips with the prescribed values; these give the height where they do not press the lines flat.
std::vector<Panel> drawn(Panel panel, const std::string& y_label,
                         const std::vector<Stretch>& prescribed = {}, double share_within = 1.0) {
  drop_high_slips(panel, share_within);
  const double lines_m = largest_y(panel) > 0.0 ? largest_y(panel) : 1.0;
  double top_m = lines_m;
  for (const Stretch& at : prescribed)
    if (at.line.value_m < 3.0 * lines_m) top_m = std::max(top_m, at.line.value_m);
  panel.y = length_axis(y_label, 1.08 * top_m);
  for (const auto& [line, from, to] : prescribed)
    panel.rules.push_back({Rule::Kind::horizontal, line.value_m, prescribed_look(line),
                           line.names() + ": " + short_length(line.value_m) +
                               (line.provenance == Provenance::recalled ? " (recalled)" : "") +
                               (line.value_m > panel.y.high ? ", above the figure" : ""),
                           from, to});
  return {panel};
}

Figure chart_slope_figure(const Results& results) {
  const ChartPoint& shown = shown_point(results);
  View view{chart_table(results), "slope", {}, shown_but(results, "slope")};
  static constexpr Role roles[] = {Role::clearance, Role::p84, Role::p95, Role::largest};
  for (const ChartStatistic& statistic : chart_statistics(results)) {
    if (statistic.stem == "mean_slip") continue;  // a part of the clearance
    const Role role = roles[view.lines.size()];
    view.lines.push_back({statistic.name, look(role),
                          role == Role::clearance ? as_line_and_points : as_line, statistic.stem});
  }
  const Panel panel = panel_of(view, slope_label);
  std::vector<Stretch> prescribed;
  std::string out_of_range;
  for (const PrescribedLine& line : prescribed_at(*results.chart, shown.level)) {
    if (shown.mu >= line.mu_limit()) {
      prescribed.push_back({line, panel.x.low, std::min(line.slope_limit(), panel.x.high)});
    } else {
      out_of_range = fmt::format(" {} is not drawn: it is for friction of {} or more.",
                                 line.label(), line.mu_limit());
    }
  }
  const std::string reading = is_one_record(results) ? "Peak slip at each slope."
                                                     : "Thick: the " + design_name(results) + ", " +
                                                           clearance_rule(results) +
                                                           "; thin: percentiles, and the largest.";
  return {"chart_slope",
          shown_title(results) + (is_one_record(results) ? "" : " and percentiles of slip") +
              " over the slope of the roof",
          suite_text(results) + at_intensity(results, shown.level) + "; " + friction_text(shown.mu),
          caption_of(results, reading) + out_of_range,
          drawn(panel, "Displacement in plan", prescribed)};
}

Figure chart_friction_figure(const Results& results) {
  const Chart& chart = *results.chart;
  const double level = shown_point(results).level;
  const std::vector<std::size_t> slopes = spread(chart.slope_deg.size(), most_curves);
  const Panel panel =
      panel_of({chart_table(results), "mu",
                lines_by(results, "slope", chart.slope_deg, slopes,
                         [](const Results&, double deg) { return "slope " + degrees(deg); }),
                shown_but(results, "mu", "slope")},
               "Coefficient of friction");
  std::vector<Stretch> prescribed;
  std::string limits;  // on the slopes that the prescribed values are for
  for (const PrescribedLine& line : prescribed_at(chart, level)) {
    const double from = std::max(line.mu_limit(), panel.x.low);
    if (from >= panel.x.high) continue;
    prescribed.push_back({line, from, panel.x.high});
    limits += fmt::format("{}{} to {:.3g}", limits.empty() ? "; " : ", ", line.names(),
                          line.slope_limit());
  }
  if (!limits.empty()) limits += " degrees";
  return {"chart_friction", shown_title(results) + " over friction, by roof slope",
          suite_text(results) + at_intensity(results, level) + limits,
          caption_of(results,
                     "Read up from the coefficient of friction to the curve of the roof's "
                     "slope, then left: the " +
                         design_name(results) + "." +
                         (slopes.size() < chart.slope_deg.size()
                              ? " The slopes between those that are drawn are in the table."
                              : "")),
          drawn(panel, y_label(results), prescribed, 0.8)};
}

Figure chart_intensity_figure(const Results& results) {
  const std::vector<double>& mu = results.chart->mu;
  const View view{chart_table(results), "level",
                  lines_by(results, "mu", mu, spread(mu.size(), most_curves),
                           [](const Results&, double value) { return friction_text(value); }),
                  shown_but(results, "level", "mu")};
  return {"chart_intensity", shown_title(results) + " over intensity, by friction",
          suite_text(results) + "slope " + degrees(shown_point(results).slope_deg),
          caption_of(results, "The " + design_name(results) +
                                  " over intensity, a curve for each coefficient of friction: none "
                                  "up to a level that grows with friction."),
          drawn(panel_of(view, results.intensity_label), y_label(results), {}, 0.88)};
}

Figure chart_slope_levels_figure(const Results& results) {
  std::vector<std::size_t> levels = spread(results.levels.size(), most_curves + 1);
  if (results.levels.front() == 0.0 || levels.size() > most_curves) levels.erase(levels.begin());
  const View view{
      chart_table(results), "slope",
      lines_by(results, "level", results.levels, levels,
               [](const Results& of, double level) { return with_unit(of, brief(level)); }),
      shown_but(results, "slope", "level")};
  return {"chart_slope_levels", shown_title(results) + " over the slope of the roof, by intensity",
          suite_text(results) + friction_text(shown_point(results).mu) + "; a curve per level, " +
              results.intensity_label,
          caption_of(results, "The " + design_name(results) +
                                  " over slope, a curve for each level of intensity."),
          drawn(panel_of(view, slope_label), y_label(results))};
}

Figure chart_period_figure(const Results& results) {
  const ChartPoint& point = shown_point(results);
  View view{chart_by_period_table(results), "period", {}, shown_but(results, "period")};
  const bool one_record = is_one_record(results);
  const ChartStatistic design = design_statistic(results);
  if (!one_record)
    view.lines = {{"mean over records", look(Role::mean), as_line_and_points, "mean_slip"},
                  {"95th percentile", look(Role::p95), as_line_and_points, "p95_slip"}};
  view.lines.push_back(
      {"largest", look(Role::largest), as_line_and_points, one_record ? design.stem : "envelope"});
  Panel panel = panel_of(view, "Building period (s)");
  const std::string name = one_record ? "largest over periods" : design.name;
  const double slip_m = design.slip_m(point);
  panel.series.push_back({DataSeries::Kind::line, look(Role::clearance), name, name,
                          panel.series.front().x,
                          std::vector(panel.series.front().x.size(), slip_m)});
  std::vector<Stretch> prescribed;
  for (const PrescribedLine& line : prescribed_at(*results.chart, point.level)) {
    if (std::ranges::any_of(line.standards, [&](Standard standard) {
          return applies_at(standard, point.slope_deg, point.mu);
        }))
      prescribed.push_back({line, panel.x.low, panel.x.high});
  }
  return {"chart_period",
          (one_record ? shown_title(results) : "Mean, 95th percentile and largest slip") +
              " over the period of the building",
          fmt::format("{}{}; slope {}; {}", suite_text(results), at_intensity(results, point.level),
                      degrees(point.slope_deg), friction_text(point.mu)),
          caption_of(results, one_record
                                  ? "Peak slip by building period; thick: the largest, "
                                    "which the chart shows."
                                  : fmt::format("Slip by building period. Thick: the {}, "
                                                "{:g} x the largest of the means.",
                                                design_name(results), clearance_factor(results))),
          drawn(panel, "Displacement in plan", prescribed)};
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
