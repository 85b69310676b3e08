// SPDX-License-Identifier: GPL-3.0-or-later
#include "by_record/line_draws.hpp"

#include <algorithm>
#include <cmath>

#include "glissade/core/distributions.hpp"
#include "glissade/core/normal.hpp"

namespace glissade::fragility {
namespace {

constexpr int draws = 2000;

/// Even points in the unit square: fractional parts of multiples of 1/g and 1/g^2, g^3 = g + 1.
double even(int i, double step) {
  const double x = 0.5 + (i + 1) * step;
  return x - std::floor(x);
}

struct StandardDraw {
  double variance_ratio;  ///< of the records in the sample over the true one
  double normal;
};

/// The same for every fit on so many records, so they are made when their number changes only:
/// quantiles of chi-square take longer than the rest of an interval.
const std::vector<StandardDraw>& standard_draws(double records) {
  static thread_local double made_for = 0.0;
  static thread_local std::vector<StandardDraw> made;
  if (made_for == records) return made;
  made_for = 0.0;
  made.clear();
  for (int i = 0; i < draws; ++i) {
    made.push_back({chi_squared_quantile(records - 1.0, even(i, 0.7548776662466927)) / records,
                    normal_quantile(even(i, 0.5698402909980532))});
  }
  made_for = records;
  return made;
}

/// Lines about y, where the variance of the height is that of the sandwich.
class LinesAbout {
 public:
  LinesAbout(const LineWithErrors& fit, double y)
      : y_(y), slope_(fit.line[1]), height_(fit.line[0] + fit.line[1] * y) {
    const double freedom = fit.records - 1.0;
    const Eigen::Vector2d at{1.0, y};
    const double variance = at.dot(fit.sandwich * at);
    share_ = std::clamp(freedom * variance, 1e-12, 1.0);
    error_ = std::sqrt(variance * freedom / (freedom + 1.0));
    slope_error_ = std::sqrt(2.0 * freedom * fit.sandwich(1, 1)) / (slope_ * share_);
  }
  ProbitLine draw(const StandardDraw& standard, double power) const {
    const auto [variance_ratio, normal] = standard;
    const double all = share_ + (1.0 - share_) * variance_ratio;
    const double slope = slope_ * std::pow(variance_ratio / all, 0.5 * power);
    return {height_ + error_ * normal / std::sqrt(all) - slope * y_, slope};
  }
  /// At which the variance of the slope is not below that of the sandwich.
  double power() const { return std::max(1.0, slope_error_); }

 private:
  double y_, slope_, height_;
  double share_;  ///< of the variance between records in the variance of all histories
  double error_, slope_error_;
};

}  // namespace

LineDraws draw_lines(const LineWithErrors& fit) {
  const LinesAbout median(fit, -fit.line[0] / fit.line[1]);
  const LinesAbout data(fit, -fit.inverse(0, 1) / fit.inverse(1, 1));
  LineDraws lines;
  for (const StandardDraw& standard : standard_draws(fit.records)) {
    lines.about_median.push_back(median.draw(standard, 1.0));
    lines.about_data.push_back(data.draw(standard, data.power()));
  }
  return lines;
}

}  // namespace glissade::fragility
