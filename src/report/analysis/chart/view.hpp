// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "glissade/report/figure.hpp"
#include "glissade/study/results.hpp"

// What figures, tables and sentences of a design chart share. All expect results with a chart.
namespace glissade {

/// Of one record its peak slip is shown: there is no mean or percentile, and no clearance.
bool is_one_record(const Results& results);

/// A number of a chart that is read off: the clearance and the numbers with it.
struct ChartStatistic {
  std::string stem;     ///< "clearance", "mean_slip": the CSV name without its unit
  std::string heading;  ///< "Design displacement (1.1 x mean)"
  std::string name;     ///< in a sentence: "84th percentile"
  double (*slip_m)(const ChartPoint&);
  double ChartReading::*reading;
};
/// What is drawn where there is one curve for each of several: "design displacement", "peak slip",
/// or "1.1 x mean slip" where the levels scale the suite to no design spectrum.
std::string design_name(const Results& results);
/// The same as the begin of a title.
std::string design_title(const Results& results);
/// Of what a figure's lines are: "1.1 x the largest mean displacement", "Peak slip under the record
/// far_field_1".
std::string shown_title(const Results& results);
/// On the mean: that of [clearance], else 1.1 (Walters et al. 2012).
double clearance_factor(const Results& results);
/// "1.1 x the mean over the records, each in the orientation that slides farthest": not the rule of
/// [clearance], which takes all records in the same orientation.
std::string clearance_rule(const Results& results);
/// The number to design with: the factor x the largest mean, or the record's peak.
ChartStatistic design_statistic(const Results& results);
/// It and the others; of one record, it alone.
std::vector<ChartStatistic> chart_statistics(const Results& results);

/// The chart's axes: which of their values is nearest.
std::size_t nearest(const std::vector<double>& axis, double value);
const ChartPoint& shown_point(const Results& results);
/// Up to `count` indices below `size`, evenly spaced from the first, and the last.
std::vector<std::size_t> spread(std::size_t size, std::size_t count);

/// "0.55": up to four digits, none of them an idle zero.
std::string brief(double value);
/// "2 degrees"
std::string degrees(double slope_deg);
/// "a slope of 2 degrees and a coefficient of friction of 0.5"
std::string at_slope_and_friction(double slope_deg, double mu);
/// "15 slopes x 15 coefficients of friction x 3 building periods x 2 levels of S_DS (g)"
std::string chart_size(const Results& results);
/// How many records stand behind a number, in which orientation and for which buildings; what is
/// pooled where samples are drawn.
std::string how_counted(const Results& results);

/// "slopes of 3 degrees or less and friction of 0.4 or more (recalled)"
std::string limits_of(Standard standard);
/// Within those limits.
bool applies_at(Standard standard, double slope_deg, double mu);

/// Standards that prescribe the same at a level: one line in a figure.
struct PrescribedLine {
  double value_m = 0.0;
  std::vector<Standard> standards;
  Provenance provenance = Provenance::checked;  ///< recalled if any is
  bool only(Standard standard) const {
    return standards.size() == 1 && standards.front() == standard;
  }
  /// As far as one of them goes: slopes up to here, friction from here on.
  double slope_limit() const;
  double mu_limit() const;
  std::string names() const;  ///< "SEAOC PV1-2012 and ASCE 7-16"
  std::string label() const;  ///< with the value, and whether it must be verified
};
/// Dashes; of ASCE 7-16 alone dots.
Look prescribed_look(const PrescribedLine& line);
std::vector<PrescribedLine> prescribed_at(const Chart& chart, double level);
/// What a standard prescribes at a level.
std::optional<double> prescribed_m(const Chart& chart, Standard standard, double level);
/// The standards of a chart, each once.
std::vector<Standard> standards_of(const Chart& chart);

}  // namespace glissade
