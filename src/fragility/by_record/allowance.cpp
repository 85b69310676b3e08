// SPDX-License-Identifier: GPL-3.0-or-later
#include "by_record/allowance.hpp"

#include <algorithm>
#include <cmath>

#include "glissade/core/distributions.hpp"

namespace glissade::fragility {
Allowance::Allowance(const Records& data, const ProbitLine& maximum, bool extrapolated,
                     bool exceeding)
    : maximum_(maximum),
      information_(likelihood(data.pooled(), maximum).information),
      records_(std::max(2.0, data.worth().records)),
      per_record_(data.one_row_each() ? 1.0 : data.worth().rows_per_record()),
      counts_(data.independent_counts()) {
  rows_ = records_ * per_record_;
  const bool grouped = !data.one_row_each();
  const double freedom = std::max(1.0, data.worth().freedom),
               contributing = std::max(1.0, data.contributing(exceeding) - 1),
               degrees = extrapolated && grouped ? std::min(contributing, freedom) : freedom;
  t_squared_ = std::pow(student_quantile(degrees, 0.975), 2);
  z_squared_ = chi_squared_quantile(1, 0.95);
  const Eigen::Matrix2d inverse = information_.inverse(),
                        of_rows = inverse * data.score_variance(maximum) * inverse;
  origin_ = -of_rows(0, 1) / of_rows(1, 1);
  const Eigen::Vector2d height{1, origin_};
  height_variance_ = height.dot(of_rows * height);
  slope_variance_ = of_rows(1, 1);
  const double small_sample = records_ / (records_ - 1);
  height_effect_ = small_sample;
  if (grouped) {
    // What leaving out a record changes (the jackknife), by its part of the weight.
    const auto variance_of = [&](const Eigen::Vector2d& direction) {
      const Eigen::ArrayXd changes =
          (data.scores(maximum) * (inverse * direction)).array() / (1 - data.parts_of_weight());
      return changes.square().sum() / small_sample;
    };
    const double variance = variance_of(height);
    if (data.has_gaps()) least_slope_effect_ = variance_of({0, 1}) / slope_variance_;
    const double least = chi_squared_quantile(records_ - 1, 0.05) / (records_ - 1) * small_sample;
    identical_ = variance < 1e-9 * height_variance_;
    height_effect_ = std::max(least, variance / height_variance_);
    part_ = std::min(1.0, height_effect_ / small_sample / per_record_);
    const double between = part_ * part_ / (records_ - 1),
                 within = (1 - part_) * (1 - part_) / (rows_ - records_);
    part_of_change_ = between / (between + within);
  }
  const double high = std::sqrt(height_variance_ * height_effect_),
               steep = std::sqrt(slope_variance_ * slope_effect(maximum[1]));
  half_axes_ << high, -origin_ * steep, 0, steep;
}

/// Of records on the variance of the slope, where it is `slope`: by the variance between records,
/// which is larger where all of it is, and the degrees of freedom of both parts (Satterthwaite
/// 1946). Records at some levels only differ from level to level: not below what they show.
double Allowance::slope_effect(double slope) const {
  const double larger = std::pow(maximum_[1] / slope, 2);
  const double part = std::clamp((part_ + part_of_change_ * (larger - 1)) / larger, 0.0, 1.0);
  const double within = rows_ > records_ ? (1 - part) * (1 - part) / (rows_ - records_) : 0;
  return std::max(least_slope_effect_, rows_ * (part * part / (records_ - 1) + within));
}

double Allowance::operator()(const ProbitLine& line) const {
  if (counts_) return z_squared_;
  const Eigen::Vector2d change = line - maximum_;
  const double height = std::pow(change[0] + origin_ * change[1], 2) / height_variance_,
               slope = change[1] * change[1] / slope_variance_;
  const double effect = slope_effect(line[1]), high = height / height_effect_,
               steep = slope / effect;
  const double all = high + steep, effective = rows_ * all / (height + slope);
  const double student = effective * std::log1p(t_squared_ / effective);
  // Of the slope Student's t has as many degrees of freedom as it is worth, E: E ln(1 + t^2/E).
  const double of_slope = z_squared_ * (1 + 0.5 * effect / rows_);
  const double quantile = per_record_ > 1 ? (high * student + steep * of_slope) / all : student;
  return change.dot(information_ * change) / all * quantile;
}

}  // namespace glissade::fragility
