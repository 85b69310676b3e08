// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/report/figure.hpp"
#include "glissade/report/table.hpp"
#include "glissade/study/results.hpp"

// The report of a design chart. All expect results with a chart.
namespace glissade {

inline constexpr int chart_height_px = 500;  ///< to read numbers off
/// Over friction (x) and slope: lines of equal clearance, and of what the standards prescribe.
Figure chart_contours_figure(const Results& results);
/// Those the chart's axes can fill: of clearance over friction, over slope, over intensity
/// (Rodriguez-Nikl et al. 2019, fig. 10) and over slope by level (their fig. 11); of displacement
/// over the building's period (Walters et al. 2012, fig. 13).
std::vector<Figure> chart_figures(const Results& results);

/// The interpolation table: every point of the chart.
Table chart_table(const Results& results);
/// The same for each building period by itself.
Table chart_by_period_table(const Results& results);
/// Questions and answers, a row for every number read off.
Table chart_readings_table(const Results& results);
/// The same for people, a row for every question.
Table chart_answers_table(const Results& results);
/// Prescribed values by standard and level beside the clearances.
Table chart_standards_table(const Results& results);
/// The clearance over slope (rows) and friction at the shown level, up to `most` of each.
Table chart_matrix_table(const Results& results, std::size_t most);
/// Those that are files of their own.
std::vector<Table> chart_csv_tables(const Results& results);

/// "Displacement at S_DS = 1.00 g, slope 2 degrees, friction 0.5"
std::string question_text(const Results& results, const ChartQuestion& question);
/// "0.300 m (11.8 in)", "0.513", "more than 0.8"
std::string answer_text(const Chart& chart, const ChartQuestion& question, double answer);
/// What came out, in sentences.
std::vector<std::string> chart_sentences(const Results& results);
/// For the terminal, in ASCII, without skips and notes.
std::string chart_summary(const Results& results);

}  // namespace glissade
