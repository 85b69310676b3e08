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

/// Up to `count` of sorted values, evenly spread, both ends included.
std::vector<double> some_of(const std::set<double>& values, std::size_t count) {
  std::vector<double> all(values.begin(), values.end());
  if (all.size() <= count) return all;
  std::vector<double> some;
  for (std::size_t i = 0; i < count; ++i) some.push_back(all[i * (all.size() - 1) / (count - 1)]);
  return some;
}

/// On an axis of logarithms; a ratio below the axis is at its low end.
constexpr double least_ratio = 0.1;
double height(const VerdictRow& row) {
  return std::log10(std::max(least_ratio, row.displacement_m.front() / row.prescribed.value_m));
}

Axis ratio_axis(double highest) {
  Axis axis{"Ratio to the prescribed value",
            std::log10(least_ratio),
            highest,
            {},
            Axis::Values::logarithms};
  for (double decade = least_ratio; std::log10(decade) <= highest; decade *= 10.0) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double at = std::log10(digit * decade);
      if (at <= highest) axis.ticks.push_back({at, fmt::format("{:g}", digit * decade)});
    }
  }
  return axis;
}

}  // namespace

Figure verdict_figure(const Results& results) {
  const VerdictResults& verdict = *results.verdict;
  const Standard standard = verdict.rows.back().standard;
  std::set<double> slopes, frictions;
  for (const VerdictRow& row : verdict.rows) {
    slopes.insert(row.slope_deg);
    frictions.insert(row.mu);
  }
  const std::vector<double> shown = some_of(frictions, most_lines);
  const double accepted = 100.0 * verdict.exceedance.front();
  Figure figure{
      "verdict",
      fmt::format("Displacement that {:g} % exceed at DBE, over that of {}", accepted,
                  standard_name(standard)),
      results.suites.front().name + ", " + counts_of(results) +
          "; the least favourable building period; at the lines: friction",
      fmt::format(
          "At the lines: coefficient of friction. Above 1 the prescribed displacement is exceeded "
          "with more than {:g} % "
          "probability, given the design earthquake. Ratios below {:g} stand there; a line ends "
          "where the array slides freely. All frictions and slopes, with intervals: "
          "tables/verdict.csv.",
          accepted, least_ratio)};
  const double highest_sds_g = verdict.rows.back().sds_g;
  double highest = std::log10(2.0);
  for (const double slope : some_of(slopes, most_panels)) {
    Panel panel{fmt::format("slope {:.3g} degrees", slope), {results.intensity_label}, {}};
    for (std::size_t i = 0; i < shown.size(); ++i) {
      DataSeries line{DataSeries::Kind::line_and_points, family_look(i, shown.size()),
                      fmt::format("friction {:.3g}", shown[i]), fmt::format("{:.3g}", shown[i])};
      for (const VerdictRow& row : verdict.rows) {
        if (row.standard != standard || row.mu != shown[i] || row.slope_deg != slope) continue;
        // Of arrays that differ in something else the largest is drawn.
        const auto at = std::ranges::find(line.x, row.sds_g);
        if (at != line.x.end()) {
          double& drawn = line.y[static_cast<std::size_t>(at - line.x.begin())];
          drawn = std::max(drawn, height(row));
          continue;
        }
        line.x.push_back(row.sds_g);
        line.y.push_back(height(row));
        if (std::isfinite(line.y.back())) highest = std::max(highest, line.y.back() + 0.05);
      }
      panel.series.push_back(std::move(line));
    }
    panel.rules.push_back({Rule::Kind::horizontal, 0.0, look(Role::prescribed), ""});
    panel.x.high = highest_sds_g;
    figure.panels.push_back(std::move(panel));
  }
  for (Panel& panel : figure.panels) panel.y = ratio_axis(highest);
  figure.labels_at_lines = true;
  return figure;
}

}  // namespace glissade
