// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "glissade/core/finite.hpp"
#include "glissade/study/analysis/chart.hpp"

namespace glissade {
namespace {

/// A value's place on an axis: in the cell after `cell`, at `share` of it.
struct Place {
  std::size_t cell;
  double share;
};
Place place_on(const std::vector<double>& axis, double value) {
  if (axis.size() == 1) return {0, 0.0};
  const auto above = std::upper_bound(axis.begin() + 1, axis.end() - 1, value);
  const auto cell = static_cast<std::size_t>(above - axis.begin()) - 1;
  return {cell, (value - axis[cell]) / (axis[cell + 1] - axis[cell])};
}

/// Between two slips, one of which may be infinite: then so is all but the other end.
double between(double low, double high, double share) {
  if (share == 0.0) return low;
  if (share == 1.0) return high;
  return (1.0 - share) * low + share * high;
}

/// One slip over friction, at one level and slope.
template <class Slip>
std::vector<double> over_friction(const Chart& chart, std::size_t level, double slope_deg,
                                  Slip slip) {
  const Place slope = place_on(chart.slope_deg, slope_deg);
  std::vector<double> row;
  for (std::size_t m = 0; m < chart.mu.size(); ++m) {
    row.push_back(
        between(slip(chart.at(level, slope.cell, m)),
                slip(chart.at(level, std::min(slope.cell + 1, chart.slope_deg.size() - 1), m)),
                slope.share));
  }
  return row;
}

/// The least friction from which on slip stays within `limit_m`; +inf where it never does, the
/// chart's least where it always does.
double friction_needed(const std::vector<double>& mu, const std::vector<double>& slip_m,
                       double limit_m) {
  std::size_t m = mu.size();
  while (m > 0 && slip_m[m - 1] <= limit_m) --m;
  if (m == mu.size()) return infinity;
  if (m == 0) return mu.front();
  const double over = slip_m[m - 1], within = slip_m[m];
  if (std::isinf(over)) return mu[m];
  return between(mu[m - 1], mu[m], (over - limit_m) / (over - within));
}

}  // namespace

ChartReading read_off(const Chart& chart, const std::vector<double>& levels,
                      const ChartQuestion& question) {
  const auto level = static_cast<std::size_t>(
      std::find(levels.begin(), levels.end(), question.level) - levels.begin());
  const auto answer = [&](auto slip) {
    const std::vector<double> row = over_friction(chart, level, question.slope_deg, slip);
    if (question.displacement_m) return friction_needed(chart.mu, row, *question.displacement_m);
    const Place mu = place_on(chart.mu, *question.mu);
    return between(row[mu.cell], row[std::min(mu.cell + 1, row.size() - 1)], mu.share);
  };
  return {.question = question,
          .mean = answer([](const ChartPoint& p) { return p.largest.mean_m; }),
          .clearance = answer([](const ChartPoint& p) { return p.clearance_m; }),
          .p84 = answer([](const ChartPoint& p) { return p.largest.p84_m; }),
          .p95 = answer([](const ChartPoint& p) { return p.largest.p95_m; }),
          .envelope = answer([](const ChartPoint& p) { return p.largest.envelope_m; })};
}

}  // namespace glissade
