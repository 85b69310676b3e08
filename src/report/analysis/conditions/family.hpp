// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/conditions/view.hpp"
#include "glissade/report/figure.hpp"
#include "glissade/study/analysis/conditions/suite_mean.hpp"

// What the figures that show suite means as lines share.
namespace glissade {

inline constexpr auto period_label = "Period of the building (s)";

/// All places of two axes, the others as shown.
Places places_of(const ConditionGrid& grid, ConditionAxis slow, ConditionAxis fast);

enum class Spread { none, bands, bars };

/// Lines of medians over the orientations, with the range from the lowest to the highest of them.
class Family {
 public:
  Family(const Results& results, const std::string& x_label, std::vector<double> x,
         Spread spread = Spread::bands);

  /// The median over the orientations at the places, one for each x.
  void add(const std::string& label, Look look, const Places& places,
           const MeanQuestion& question = {}, Periods periods = Periods::one);
  /// The same of numbers by orientation; they are sorted. Empty: a gap.
  void add_numbers(const std::string& label, Look look,
                   const std::vector<std::vector<double>>& numbers);
  /// A line without spread.
  void add_line(const std::string& label, Look look, std::vector<double> y);
  void add_level(double y, const std::string& label, Look look);
  void name_ticks(const std::vector<std::string>& labels);

  /// Displacements in metres and inches from 0 on.
  std::vector<Panel> displacements(const std::string& label = "Mean displacement");
  /// Numbers without a unit, from 0 or from below the lowest on.
  enum class From { zero, lowest };
  std::vector<Panel> ratios(const std::string& label, From from = From::zero);

 private:
  void add_range(const std::string& label, Look look, const std::vector<double>& lowest,
                 const std::vector<double>& median, const std::vector<double>& highest);
  double largest_y() const;
  double smallest_y() const;

  const Results& results_;
  std::vector<double> x_;
  Spread spread_;
  Panel panel_;
  std::vector<DataSeries> spreads_;
};

/// Suite, and every condition that is the same all over: those of `shown`, the building's period
/// and the support vary.
std::string below_text(const Results& results, std::vector<ConditionAxis> shown = {});
/// For captions: what a displacement is.
std::string what_is_averaged(const Results& results);

}  // namespace glissade
