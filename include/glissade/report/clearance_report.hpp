// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glissade/report/figure.hpp"
#include "glissade/report/table.hpp"
#include "glissade/study/analysis/clearance_reading.hpp"

namespace glissade {

/// By condition but the period: the largest suite mean over the periods, over the orientations, and
/// the clearance.
Table clearance_table(const ClearanceResults& results);
/// By condition and period: the suite's mean over the orientations, and its bounds with the
/// orientation chosen record by record.
Table clearance_periods_table(const ClearanceResults& results);
/// Every orientation by itself, at the first of every other condition.
Table clearance_orientations_table(const ClearanceResults& results);
/// Base shear over the bare building's weight, by period and support.
Table clearance_base_shear_table(const ClearanceResults& results);
/// Every history that was run.
Table clearance_histories_table(const ClearanceResults& results);

/// One for every topic the study's grid can fill: those whose axis has two values or more.
std::vector<Figure> clearance_figures(const ClearanceResults& results);

/// The results on a topic in sentences; "" where the grid has too few values for it.
std::string clearance_reading(const ClearanceResults& results, ClearanceTopic topic);
/// What was run, and the readings.
std::vector<std::string> clearance_sentences(const ClearanceResults& results);
/// For the terminal, in plain ASCII.
std::string clearance_summary(const ClearanceResults& results);

/// The tables of a page, and those that are files only.
std::vector<Table> clearance_tables(const ClearanceResults& results);
std::vector<Table> clearance_file_tables(const ClearanceResults& results);
/// How a required clearance is found, in sentences.
std::vector<std::string> clearance_explained(const ClearanceResults& results);

}  // namespace glissade
