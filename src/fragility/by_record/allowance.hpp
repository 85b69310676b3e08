// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "by_record/records.hpp"

namespace glissade::fragility {

/// How far below the maximum twice the log likelihood may be at a line that the data allow at 95 %
/// (theory.md, 6.3): more in a direction in which the rows of a record say the same.
class Allowance {
 public:
  /// @param data of two records or more. @param extrapolated Student's t has the degrees of freedom
  /// of those records only that show histories which exceed (or do not, unless `exceeding`)
  Allowance(const Records& data, const ProbitLine& maximum, bool extrapolated, bool exceeding);

  double operator()(const ProbitLine& line) const;
  const Eigen::Matrix2d& half_axes() const { return half_axes_; }
  /// The records' scores do not differ at all: they show nothing of the variance between records.
  bool identical() const { return identical_; }

 private:
  double slope_effect(double slope) const;

  ProbitLine maximum_;
  Eigen::Matrix2d information_, half_axes_;
  double rows_, records_, per_record_, t_squared_, z_squared_;
  double origin_, height_variance_, slope_variance_;  // of independent rows; height at y = origin
  double height_effect_ = 1.0;                        // of records on the variance of the height
  double least_slope_effect_ = 0.0;                   // that of the slope is not below
  double part_ = 1.0;            // of the variance between records in that of all rows
  double part_of_change_ = 1.0;  // what of a change of the variance is between records
  bool counts_, identical_ = false;
};

}  // namespace glissade::fragility
