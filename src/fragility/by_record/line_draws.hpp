// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "by_record/resampling.hpp"
#include "glissade/fragility/fit.hpp"
#include "lognormal/likelihood.hpp"

namespace glissade::fragility {

/// A fitted probit line with its covariances: `sandwich` clustered by record (theory.md, 6.4) and
/// `inverse` of the information.
struct LineWithErrors {
  ProbitLine line;
  Eigen::Matrix2d sandwich, inverse;
  double records;  ///< >= 2; of weighted data the effective number
};

/// Lines that could be the true one, given the estimate (theory.md, 6.4b): all rise, so quantiles
/// of their probabilities rise with intensity. `about_median` takes the error of the slope as it
/// would be if every capacity had been observed; `about_data` that of the data, about the point
/// where it is independent of the error of the height.
struct LineDraws {
  std::vector<ProbitLine> about_median, about_data;

  std::array<std::vector<ProbitLine>, 2> families() const { return {about_median, about_data}; }
};
LineDraws draw_lines(const LineWithErrors& fit);

/// From the lowest end of the families' percentile intervals to the highest. @param quantity of a
/// member. @param tail see percentile_interval()
template <class Families>
Interval interval_over(const Families& families, const auto& quantity, double tail) {
  Interval whole;
  for (const auto& family : families) {
    std::vector<double> values;
    for (const auto& member : family) values.push_back(std::invoke(quantity, member));
    const Interval one = percentile_interval(std::move(values), tail);
    whole = {std::fmin(whole.low, one.low), std::fmax(whole.high, one.high)};
  }
  return whole;
}

}  // namespace glissade::fragility
