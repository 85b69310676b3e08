// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "analysis/verdict/kinds.hpp"
#include "glissade/report/format.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

constexpr std::size_t most_lines = 4, most_panels = 4;

std::vector<double> some_of(const std::set<double>& values, std::size_t count) {
  const std::vector<double> all(values.begin(), values.end());
  std::vector<double> some;
  for (const std::size_t i : evenly(all.size(), count)) some.push_back(all[i]);
  return some;
}

/// On an axis of logarithms; a ratio below the axis is at its low end.
constexpr double least_ratio = 0.1;
double height(double displacement_m, const VerdictRow& row) {
  return std::log10(std::max(least_ratio, displacement_m / row.prescribed.value_m));
}

/// What the rows are drawn over: S_DS, or R where there is one S_DS and several R.
class Abscissa {
 public:
  explicit Abscissa(const Results& results) : results_(results) {
    std::set<double> sds, r;
    for (const VerdictRow& row : results.verdict->rows) {
      sds.insert(row.sds_g);
      r.insert(response_modification(results, row));
    }
    over_r_ = sds.size() == 1 && r.size() > 1;
    axis_ = {over_r_ ? "R of the building" : results.intensity_label};
    axis_.high = over_r_ ? *r.rbegin() : *sds.rbegin();
    if (!over_r_) return;
    for (const double at : r)
      axis_.ticks.push_back({at, at == 0.0 ? "elastic" : fmt::format("{:g}", at)});
  }
  double of(const VerdictRow& row) const {
    return over_r_ ? response_modification(results_, row) : row.sds_g;
  }
  const Axis& axis() const { return axis_; }

 private:
  const Results& results_;
  bool over_r_ = false;
  Axis axis_;
};

/// Of one friction, with intervals.
struct FrictionLine {
  DataSeries line, bars;

  FrictionLine(double mu, std::size_t i, std::size_t count)
      : line{DataSeries::Kind::line_and_points, family_look(i, count),
             fmt::format("friction {:.3g}", mu), fmt::format("{:.3g}", mu)},
        bars{DataSeries::Kind::bars, line.look, line.name + ", 95 % interval"} {
    bars.look.width = 1.2;
  }
  /// Of arrays that differ in something else the largest is drawn.
  void add(double x, double y, const Interval& interval) {
    const auto at = static_cast<std::size_t>(std::ranges::find(line.x, x) - line.x.begin());
    if (at == line.x.size()) {
      line.add(x, -1e9);
      bars.add(x, {-1e9, -1e9});
    }
    if (y <= line.y[at]) return;
    line.y[at] = y;
    bars.low[at] = interval.low;
    bars.high[at] = interval.high;
  }
  void draw_in(Panel& panel) {
    panel.series.push_back(std::move(bars));
    panel.series.push_back(std::move(line));
  }
};

/// A displacement over the prescribed one. Without an upper end its interval is down from the
/// point.
Interval interval_of_ratio(const VerdictRow& row) {
  const auto [low_m, high_m] = row.displacement_interval.front();
  return {height(low_m, row),
          height(std::isinf(high_m) ? row.displacement_m.front() : high_m, row)};
}

/// A panel for each slope that is drawn; in it a line for each friction, to which `add` gives the
/// rows of the standard, and a horizontal line at `rule`.
template <class Add>
std::vector<Panel> panels_of(const VerdictResults& verdict, Standard standard, const Axis& x,
                             const Axis& y, double rule, Add add) {
  std::set<double> all_slopes, all_frictions;
  for (const VerdictRow& row : verdict.rows) {
    all_slopes.insert(row.slope_deg);
    all_frictions.insert(row.mu);
  }
  const std::vector<double> frictions = some_of(all_frictions, most_lines);
  std::vector<Panel> panels;
  for (const double slope : some_of(all_slopes, most_panels)) {
    Panel panel{fmt::format("slope {:.3g} degrees", slope), x, y};
    for (std::size_t i = 0; i < frictions.size(); ++i) {
      FrictionLine line(frictions[i], i, frictions.size());
      for (std::size_t at = 0; at < verdict.rows.size(); ++at) {
        const VerdictRow& row = verdict.rows[at];
        if (row.standard == standard && row.mu == frictions[i] && row.slope_deg == slope)
          add(line, at, row);
      }
      line.draw_in(panel);
    }
    panel.rules.push_back({Rule::Kind::horizontal, rule, look(Role::prescribed), ""});
    panels.push_back(std::move(panel));
  }
  return panels;
}

/// What the other standards prescribe over what this one does.
std::vector<DataSeries> other_standards(const VerdictResults& verdict, Standard standard,
                                        const Abscissa& abscissa) {
  std::vector<DataSeries> lines;
  for (const VerdictKind kind : verdict_kinds(verdict)) {
    if (kind.front().standard == standard) continue;
    Look dotted = look(Role::prescribed);
    dotted.dash = 3;
    DataSeries line{DataSeries::Kind::line, dotted, standard_name(kind.front().standard), ""};
    for (const VerdictRow& row : kind) {
      const VerdictRow* same = nullptr;
      for (const VerdictRow& other : verdict.rows) {
        if (other.standard == standard && other.sds_g == row.sds_g) same = &other;
      }
      if (same == nullptr) continue;
      line.add(abscissa.of(row), height(row.prescribed.value_m, *same));
    }
    if (line.x.size() > 1) lines.push_back(std::move(line));
    break;  // of all arrays the same
  }
  return lines;
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
          "; the governing building period; at the lines: friction; bars: 95 % over records" +
          (has_upper_ends(verdict) ? "" : ", lower ends (upper ends: none)"),
      fmt::format("At the lines: coefficient of friction. Above 1 the prescribed displacement is "
                  "exceeded with more than {:g} % probability, given the design earthquake. Bars: "
                  "95 % intervals over records; one that ends at its point has no upper end: the "
                  "records are too few for one. Dotted: what the other standard prescribes over "
                  "it. Ratios below {:g} are drawn at it; a line ends where the array slides "
                  "freely. All frictions and slopes, with intervals: tables/verdict.csv.",
                  accepted, least_ratio)};
  const Abscissa abscissa(results);
  const std::vector<DataSeries> others = other_standards(verdict, standard, abscissa);
  for (const DataSeries& other : others) figure.below += "; dotted: " + other.name;
  figure.panels = panels_of(verdict, standard, abscissa.axis(), {}, 0.0,
                            [&](FrictionLine& line, std::size_t, const VerdictRow& row) {
                              line.add(abscissa.of(row), height(row.displacement_m.front(), row),
                                       interval_of_ratio(row));
                            });
  double highest = std::log10(2.0);
  for (Panel& panel : figure.panels) {
    for (const DataSeries& series : panel.series)
      for (const double top : series.high)
        if (std::isfinite(top)) highest = std::max(highest, top + 0.05);
    panel.series.insert(panel.series.begin(), others.begin(), others.end());
  }
  for (Panel& panel : figure.panels)
    panel.y = log_axis("Ratio to the prescribed value", std::log10(least_ratio), highest,
                       [](double ratio) { return fmt::format("{:g}", ratio); }, {1.0, 2.0, 5.0});
  figure.labels_at_lines = true;
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
          neighbours_text(results) +
          "; the governing building period; at the lines: friction; bars: 95 % over records",
      fmt::format(
          "At the lines: coefficient of friction of the array; that of its neighbour is drawn "
          "(study). The larger of the gaps along and across the slope. Horizontal line: {:g} %. "
          "All frictions, slopes and separations: tables/verdict_separations.csv.",
          accepted)};
  const Abscissa abscissa(results);
  figure.panels =
      panels_of(verdict, standard, abscissa.axis(), {"Probability (%)", 0.0, 100.0}, accepted,
                [&](FrictionLine& line, std::size_t at, const VerdictRow& row) {
                  const VerdictSeparation* gap = governing_of(separations_of(verdict, at), 0.5);
                  if (gap == nullptr) return;
                  const Interval& interval = gap->dbe.interval;
                  line.add(abscissa.of(row), 100.0 * gap->dbe.probability,
                           {100.0 * interval.low, 100.0 * interval.high});
                });
  figure.labels_at_lines = true;
  return figure;
}

}  // namespace glissade
