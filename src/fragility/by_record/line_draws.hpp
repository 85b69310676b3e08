// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "lognormal/likelihood.hpp"

namespace glissade::fragility {

/// A fitted probit line with its covariances: `sandwich` clustered by record (theory.md, 6.4) and
/// `inverse` of the information.
struct LineWithErrors {
  ProbitLine line;
  Eigen::Matrix2d sandwich, inverse;
  Eigen::Index records;  ///< >= 2
};

/// Lines that could be the true one, given the estimate (theory.md, 6.4b): all rise, so quantiles
/// of their probabilities rise with intensity. `about_median` takes the error of the slope as it
/// would be if every capacity had been observed; `about_data` that of the data, about the point
/// where it is independent of the error of the height.
struct LineDraws {
  std::vector<ProbitLine> about_median, about_data;
};
LineDraws draw_lines(const LineWithErrors& fit);

}  // namespace glissade::fragility
