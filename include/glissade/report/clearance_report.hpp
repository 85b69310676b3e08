// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/report/figure.hpp"
#include "glissade/report/table.hpp"
#include "glissade/study/results.hpp"

// The report of a required clearance. All expect results with a clearance.
namespace glissade {

/// By condition but the period: the largest suite mean over the periods, over the orientations, and
/// the clearance.
Table clearance_table(const Results& results);
/// By condition and period: the suite's mean over the orientations, and its bounds with the
/// orientation chosen record by record.
Table clearance_periods_table(const Results& results);
/// Every orientation by itself, at the first of every other condition.
Table clearance_orientations_table(const Results& results);
/// Every condition in each orientation: by period, and the largest over the periods.
std::vector<Table> clearance_by_orientation_tables(const Results& results);
/// By condition: the suite's mean over that on the building of the reference strength. Without rows
/// where no building yields.
Table clearance_yielding_table(const Results& results);
/// Every history that was run.
Table clearance_histories_table(const Results& results);

/// One for every topic the study's grid can fill: those whose axis has two values or more.
std::vector<Figure> clearance_figures(const Results& results);

/// What of a study a figure or sentence shows.
enum class ClearanceTopic {
  spectra,
  period,
  level,
  yielding,
  slope,
  mce,
  vertical,
  mass,
  orientation,
};
/// Whether a topic's axis has two values or more. Of several suites, only their comparison is
/// reported.
bool covers(const Results& results, ClearanceTopic topic);

/// The results on a topic in sentences; "" where the grid has too few values for it.
std::string clearance_reading(const Results& results, ClearanceTopic topic);
/// What was run, and the readings.
std::vector<std::string> clearance_sentences(const Results& results);
/// For the terminal, in plain ASCII.
std::string clearance_summary(const Results& results);

}  // namespace glissade
