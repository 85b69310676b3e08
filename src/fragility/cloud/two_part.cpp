// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/fragility/two_part.hpp"

#include <cmath>

#include "glissade/core/contract.hpp"
#include "glissade/core/normal.hpp"
#include "lognormal/point_fit.hpp"

namespace glissade {
namespace {

using namespace fragility;

void fit_any(const std::vector<SlipSums>& rows, TwoPartFit& fit) {
  std::vector<double> intensities;
  for (const SlipSums& row : rows) intensities.push_back(row.intensity);
  LogRows counts;
  counts.center = mean_log(intensities);
  for (const SlipSums& row : rows)
    counts.add_counts(std::log(row.intensity) - counts.center, row.moved, row.trials - row.moved);
  const PointFit line = fit_counts(counts);
  fit.any_status = line.status;
  if (line.status == FitStatus::maximum_likelihood || line.status == FitStatus::jeffreys_penalised)
    fit.any = to_curve(line.line, counts.center);
}

/// About the means, which leaves no digits to cancellation.
void fit_size(const std::vector<SlipSums>& rows, TwoPartFit& fit) {
  double n = 0, x_mean = 0, y_mean = 0;
  for (const SlipSums& row : rows) {
    n += row.moved;
    x_mean += row.moved * std::log(row.intensity);
    y_mean += row.sum_log;
  }
  if (!(n > 2)) return;
  x_mean /= n;
  y_mean /= n;
  double xx = 0, xy = 0, yy = 0;
  for (const SlipSums& row : rows) {
    const double x = std::log(row.intensity) - x_mean;
    xx += row.moved * x * x;
    xy += x * (row.sum_log - row.moved * y_mean);
    yy += row.sum_log_squares - 2 * y_mean * row.sum_log + row.moved * y_mean * y_mean;
  }
  fit.size_status = FitStatus::one_level;
  if (!(xx > 1e-18 * n)) return;
  const double slope = xy / xx, variance = (yy - slope * xy) / (n - 2);
  fit.size_status = FitStatus::failed;
  // The sums cancel: below this share of their terms the scatter is rounding.
  const double rounding = 1e-13 * (yy + n * y_mean * y_mean) / (n - 2);
  if (!(variance > rounding)) return;
  fit.size_status = slope > 0 ? FitStatus::maximum_likelihood : FitStatus::no_trend;
  fit.slope = slope;
  fit.intercept = y_mean - slope * x_mean;
  fit.log_std = std::sqrt(variance);
}

}  // namespace

void SlipSums::add(double displacement, double weight) {
  trials += weight;
  if (displacement == 0) return;
  const double y = std::log(displacement);
  moved += weight;
  sum_log += weight * y;
  sum_log_squares += weight * y * y;
}

bool TwoPartFit::has_curve() const {
  return size_status == FitStatus::maximum_likelihood &&
         (any_status == FitStatus::maximum_likelihood ||
          any_status == FitStatus::jeffreys_penalised || any_status == FitStatus::upper_bound);
}

double TwoPartFit::probability(double intensity, double threshold) const {
  GLISSADE_EXPECTS(has_curve() && threshold > 0);
  if (!(intensity > 0)) return 0;
  const double above =
      normal_cdf((intercept + slope * std::log(intensity) - std::log(threshold)) / log_std);
  return any_status == FitStatus::upper_bound ? above : any.probability(intensity) * above;
}

TwoPartFit fit_two_part(const std::vector<SlipSums>& rows) {
  TwoPartFit fit;
  fit_any(rows, fit);
  fit_size(rows, fit);
  return fit;
}

}  // namespace glissade
