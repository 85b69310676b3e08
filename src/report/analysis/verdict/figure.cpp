// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ranges>
#include <set>

#include "analysis/verdict/kinds.hpp"
#include "glissade/report/format.hpp"
#include "plot/view.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

constexpr std::size_t most_lines = 6, most_panels = 4;

std::vector<double> some_of(const std::set<double>& values, std::size_t count) {
  const std::vector<double> all(values.begin(), values.end());
  std::vector<double> some;
  for (const std::size_t i : evenly(all.size(), count)) some.push_back(all[i]);
  return some;
}

constexpr double least_ratio = 0.1;  // that is drawn

/// Slopes or frictions of all rows.
std::set<double> all_of(const VerdictResults& verdict, double VerdictRow::*of) {
  std::set<double> values;
  for (const VerdictRow& row : verdict.rows) values.insert(row.*of);
  return values;
}

/// Over S_DS, or over R where there is one S_DS and several R (elastic: R = 1): of the rows of a
/// standard a panel for each slope that is drawn, a line with intervals for each friction, and a
/// horizontal line. Of arrays that differ in something else the one with the largest y is drawn.
std::vector<Panel> panels_of(const Results& results, Table table, const std::string& y,
                             const Rule& rule) {
  const VerdictResults& verdict = *results.verdict;
  std::set<double> strengths;
  for (const VerdictRow& row : verdict.rows) strengths.insert(response_modification(results, row));
  const bool over_r = strengths.size() > 1 && all_of(verdict, &VerdictRow::sds_g).size() == 1;
  const std::string x = over_r ? "response_modification" : "sds";
  keep_largest(table, {"standard", "mu", "slope", x}, y);
  View view{table, x, {}, {{"standard", standard_name(verdict.rows.back().standard)}}};
  view.spread = DataSeries::Kind::bars;
  const double x_end = over_r ? *strengths.rbegin() : results.levels.back();
  view.apart = 0.006 * x_end;  // of one bar beside the next
  const double elastic_at = over_r ? std::min(1.0, *std::next(strengths.begin()) - 0.5) : 0.0;
  if (over_r) {
    for (const double r : strengths) {
      const double at = r == 0.0 ? elastic_at : r;
      view.places.push_back({r, {at, fmt::format("{:g}", at)}});
    }
  }
  const std::string label =
      "Response modification R" +
      (*strengths.begin() == 0.0 ? fmt::format(" ({:g}: elastic)", elastic_at) : "");
  const std::vector<double> frictions = some_of(all_of(verdict, &VerdictRow::mu), most_lines);
  std::vector<Panel> panels;
  for (const double slope_deg : some_of(all_of(verdict, &VerdictRow::slope_deg), most_panels)) {
    view.lines.clear();
    for (const double mu : frictions)
      view.lines.push_back({fmt::format("friction {:.3g}", mu),
                            family_look(view.lines.size(), frictions.size()),
                            as_line_and_points,
                            y,
                            {{"mu", mu}, {"slope", slope_deg}},
                            y + "_low95",
                            y + "_high95"});
    Panel panel = panel_of(view, over_r ? label : results.intensity_label);
    panel.title = fmt::format("slope {:.3g} degrees", slope_deg);
    const double room = 0.06 * x_end;  // for bars and points beside the ends
    panel.x.low = over_r ? panel.x.low - room : 0.0;
    panel.x.high += room;
    panel.rules.push_back(rule);
    panels.push_back(std::move(panel));
  }
  return panels;
}

/// Leaves panels out in which no line is above `least`, unless all are; what the figure has to say
/// of them.
std::string leave_out_below(std::vector<Panel>& panels, double least, std::string (*text)(double)) {
  const auto largest_of = [](const Panel& panel, std::vector<double> DataSeries::*values) {
    double found = 0.0;
    for (const DataSeries& series : panel.series) found = std::max(found, largest(series.*values));
    return found;
  };
  const auto is_below = [&](const Panel& panel) {
    return largest_of(panel, &DataSeries::y) <= least;
  };
  if (std::ranges::all_of(panels, is_below)) return "";
  std::string left_out;
  for (const Panel& panel : panels | std::views::filter(is_below))
    left_out += fmt::format("; not drawn: {}, at most {} (intervals to {})", panel.title,
                            text(largest_of(panel, &DataSeries::y)),
                            text(largest_of(panel, &DataSeries::high)));
  std::erase_if(panels, is_below);
  return left_out;
}

/// What the other standard prescribes, of all arrays the same, over what this one does.
std::vector<DataSeries> other_standard(const VerdictResults& verdict, Standard standard) {
  const auto kinds = verdict_kinds(verdict);
  const auto other = std::ranges::find_if(
      kinds, [&](const VerdictKind& kind) { return kind.front().standard != standard; });
  if (other == kinds.end()) return {};
  Look dotted = look(Role::prescribed);
  dotted.dash = 3;
  const std::string name = standard_name(other->front().standard);
  DataSeries line{DataSeries::Kind::line, dotted, name, "prescribed by " + name};
  for (const VerdictRow& row : *other) {
    for (const VerdictRow& same : verdict.rows | std::views::reverse) {
      if (same.standard != standard || same.sds_g != row.sds_g) continue;
      line.add(row.sds_g, row.prescribed.value_m / same.prescribed.value_m);
      break;
    }
  }
  if (line.x.size() < 2) return {};
  return {line};
}

/// Enough records to bound what 10 % exceed.
bool has_upper_ends(const VerdictResults& verdict) {
  return std::ranges::all_of(verdict.rows, [](const VerdictRow& row) {
    return !std::isinf(row.displacement_interval.front().high);
  });
}

}  // namespace

Figure verdict_figure(const Results& results) {
  const VerdictResults& verdict = *results.verdict;
  const Standard standard = verdict.rows.back().standard;
  const double accepted = 100.0 * verdict.exceedance.front();
  Figure figure{
      "verdict",
      fmt::format("Displacement that {:g} % exceed at DBE, over that of {}", accepted,
                  standard_name(standard)),
      results.suites.front().name + ", " + counts_of(results) +
          "; the governing building; bars, side by side: 95 % over " + units_name(results) +
          (has_upper_ends(verdict) ? "" : ", lower ends (upper ends: none)"),
      fmt::format(
          "Governing: the building with the largest ratio. Above 1 the prescribed displacement is "
          "exceeded with more than {0:g} % probability, given the design earthquake. Bars: "
          "95 % intervals over {2}; one that ends at its point has no upper end: the "
          "{2} are too few for one. Dotted: what the other standard prescribes over "
          "it. Ratios below {1:g} are drawn at it; a line ends where the array slides "
          "freely. Lines are drawn a little apart, for their bars. All frictions and "
          "slopes, with intervals: tables/verdict.csv.",
          accepted, least_ratio, units_name(results))};
  const std::vector<DataSeries> others = other_standard(verdict, standard);
  Table table = verdict_table(results);
  const auto ratio = std::ranges::find(table.columns, "ratio", &Column::stem);
  for (std::vector<Cell>& row : table.rows) {  // without an upper end: down from the point
    auto& of = std::get<NumberCell>(row[static_cast<std::size_t>(ratio - table.columns.begin())]);
    if (std::isinf(of.interval.high)) of.interval.high = of.value;
  }
  figure.panels = panels_of(results, std::move(table), "ratio",
                            {Rule::Kind::horizontal, 1.0, look(Role::prescribed),
                             "prescribed by " + standard_name(standard)});
  figure.below += leave_out_below(figure.panels, least_ratio, format_number);
  double highest = 2.0;
  bool has_less = false;
  for (Panel& panel : figure.panels) {
    for (const DataSeries& series : panel.series) {
      highest = std::max(highest, 1.12 * largest(series.high));
      for (const std::vector<double>& values : {series.y, series.low})
        has_less |= std::ranges::any_of(values, [](double y) { return y < least_ratio; });
    }
    panel.series.insert(panel.series.begin(), others.begin(), others.end());
  }
  for (Panel& panel : figure.panels) {
    panel.y = log_axis("Ratio to the prescribed value", least_ratio, highest,
                       [](double ratio) { return fmt::format("{:g}", ratio); }, {1.0, 2.0, 5.0});
    if (has_less) panel.y.ticks.front().label = fmt::format("\u2264 {:g}", least_ratio);
  }
  return figure;
}

Figure verdict_separations_figure(const Results& results) {
  const VerdictResults& verdict = *results.verdict;
  const Standard standard = verdict.rows.back().standard;
  const double accepted = 100.0 * verdict.exceedance.front();
  Figure figure{
      "verdict_separations",
      fmt::format("Probability at DBE that a gap of half the displacement of {} closes",
                  standard_name(standard)),
      results.suites.front().name + ", " + counts_of(results) + "; arrays " +
          neighbours_text(results) + "; the governing building; bars, side by side: 95 % over " +
          units_name(results),
      fmt::format("Friction: of the array; that of its neighbour is drawn (study). Lines are drawn "
                  "a little apart, for their bars. The larger of the gaps along "
                  "and across the slope. Horizontal line: {:g} %. "
                  "All frictions, slopes and separations: tables/verdict_separations.csv.",
                  accepted)};
  Table table = verdict_separations_table(results);
  keep_rows(table, "factor", [](double factor) { return factor == 0.5; });
  figure.panels =
      panels_of(results, std::move(table), "dbe_probability",
                {Rule::Kind::horizontal, verdict.exceedance.front(), look(Role::prescribed),
                 fmt::format("{:g} %: more is not accepted", accepted)});
  figure.below += leave_out_below(figure.panels, 0.5 * verdict.exceedance.front(), format_share);
  for (Panel& panel : figure.panels) panel.y = share_axis("Probability");
  return figure;
}

}  // namespace glissade
