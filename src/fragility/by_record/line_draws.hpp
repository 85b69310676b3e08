// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <vector>

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
};
LineDraws draw_lines(const LineWithErrors& fit);

/// From the lowest end of the families' percentile intervals to the highest. @param quantity of a
/// line. @param tail see percentile_interval()
Interval interval_of(const LineDraws& lines,
                     const std::function<double(const ProbitLine&)>& quantity, double tail);

}  // namespace glissade::fragility
