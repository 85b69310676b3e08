// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "glissade/core/wrap.hpp"
#include "glissade/report/figure.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/table.hpp"
#include "glissade/study/results.hpp"

// What tables, figures and sentences of a study share: texts and levels.
namespace glissade {

/// In the notes of every table with displacements.
std::string in_plan(const Results& results);
/// "one axis only (model.axes = 1)" of a study whose array slides along one; else "".
std::string one_axis_text(const Results& results);
/// Of the design spectrum: "ASCE 7-16, S_S 1.5 g, S_1 0.6 g, site class D"; "" where no result
/// rests on one. Where that of several suites differs, that of the one that is shown, else that it
/// differs.
std::string target_text(const Results& results, std::optional<std::size_t> suite = {});
bool differs_by_suite(const Results& results);
/// "1.2 g": a value of the intensity measure.
std::string with_unit(const Results& results, const std::string& value);
/// A column of intensities, its unit in name and heading.
Column intensity_column(const Results& results, const std::string& stem, const std::string& heading,
                        const std::string& description);
auto intensity_column(const Results& results, const std::string& stem, const std::string& heading,
                      const std::string& description, auto value) {
  return ColumnOf{intensity_column(results, stem, heading, description), value};
}
// Columns of many tables. Their values are the members of these names, whatever a row is of.
inline auto level_column(const Results& results) {
  return intensity_column(results, "level", "Level", "intensity level",
                          [](const auto& row) -> decltype(row.level) { return row.level; });
}
/// Which combination of what the study lists a row is of: by its label, which names its files too,
/// or by what is listed.
inline const ColumnOf run_column{text_column("run", "Combination", "label in `combinations`"),
                                 [](const auto& run) -> decltype(run.label) { return run.label; }};
inline const ColumnOf condition_column{
    text_column("condition", "Combination", "which combination of what the study lists"),
    [](const auto& row) -> decltype(row.condition) { return row.condition; }};
inline const ColumnOf threshold_column{
    Column{"threshold", "m", "Clearance, m (in)", ColumnKind::length, "clearance threshold"},
    [](const auto& row) -> decltype(row.threshold_m) { return row.threshold_m; }};
inline const ColumnOf slope_column{
    Column{"slope", "deg", "Slope, degrees", ColumnKind::number, "slope of the roof"},
    [](const auto& row) -> decltype(row.slope_deg) { return row.slope_deg; }};
/// A standard, what it prescribes at which S_DS, and how well that is known.
inline const ColumnOf standard_column{text_column("standard", "Standard", "standard"),
                                      [](const auto& row) -> decltype(standard_name(row.standard)) {
                                        return standard_name(row.standard);
                                      }};
inline const ColumnOf sds_column{
    Column{"sds", "g", "S_DS, g", ColumnKind::number, "design spectral acceleration S_DS"},
    [](const auto& row) -> decltype(row.sds_g) { return row.sds_g; }};
inline const ColumnOf prescribed_column{
    Column{"prescribed", "m", "Prescribed, m (in)", ColumnKind::length, "prescribed displacement"},
    [](const auto& row) -> decltype(row.prescribed.value_m) { return row.prescribed.value_m; }};
inline const ColumnOf provision_column{
    text_column("provision", "Provision", "how well the provision is known"),
    [](const auto& row) -> decltype(provenance_name(row.prescribed.provenance)) {
      return provenance_name(row.prescribed.provenance);
    }};
/// The column of a quantity: "Building period, s".
Column listed_column(const CaseAxis& axis);
Column listed_column(const Parameter& parameter);
/// The label of a run is not all that distinguishes it from the others.
bool lists_more_than_friction_value(const Results& results);
/// A table whose rows begin with the label of a run, with a column for each quantity that the study
/// lists after it.
Table with_listed(const Results& results, const Table& table);
/// On a page the listed quantities name a run, where there are some.
Table without_run_key(const Results& results, const Table& table);
/// "S_DS = 0.840 g" from the axis label "S_DS (g)"; with " (DBE)" or " (MCE)" where it is that.
std::string at_intensity(const Results& results, double value);
/// "1.20"; of four digits where that is all of the level: "1.035".
std::string level_number(double level);
/// "6 levels"; of multiple stripes "1 of 6 levels".
std::string levels_of_each(const Results& results);
/// "22 records x 1024 samples"
std::string counts_of(const Results& results);
/// "22 records", or "22 records of 14 events" where some events have several.
std::string counted_records(const Results& results);
/// What intervals are over: "events" where some have several records, else "records".
std::string units_name(const Results& results);
std::string open_percentile(const Results& results);
/// Which combination of what the study lists a run is.
std::size_t combination_of(const Results& results, const RunResults& run);
/// Of a run, at a level; null where it is not one of its levels.
const SlipStatistics* slip_at(const RunResults& run, double level);
/// What a run is in words: "sampled friction, building period 0.5 s".
std::string run_name(const Results& results, const RunResults& run);
/// What that run is, in full.
std::string governing_text(const Results& results);
/// "mu normal, mean 0.55, std 0.04; building period 0.5 s".
std::string friction_and_listed(const Results& results, const RunResults& run);
/// "friction mu normal, mean 0.55, std 0.04" where a line has room for it, else the run's name:
/// captions have it in full.
std::string friction_of(const Results& results, const RunResults& run);
/// Below the title of a figure: "synthetic_far_field, 22 records x 64 samples; slope 1.19 to 4.76
/// degrees, buildings of T 0.2 to 2 s, m/M 0.05". Of a run also its friction.
std::string cases_below(const Results& results, CaseSlice cases);
std::string run_below(const Results& results, const RunResults& run);
/// "0.2 to 1": a quantity of the cases, times a scale.
std::string range_of(const std::vector<Case>& cases, double Case::*quantity, double scale = 1.0);
/// Neighbouring rows that are of one kind.
template <class Row>
std::vector<std::span<const Row>> groups_of(const std::vector<Row>& rows, const auto& are_of_one) {
  std::vector<std::span<const Row>> groups;
  for (std::size_t first = 0, end = 0; first < rows.size(); first = end) {
    while (end < rows.size() && are_of_one(rows[first], rows[end])) ++end;
    groups.emplace_back(rows.data() + first, end - first);
  }
  return groups;
}
/// Up to `count` of the levels, spread evenly, the highest included.
std::vector<double> some_levels(const std::vector<double>& levels, std::size_t count);

/// Up to `count` (2 or more) positions below `size`, evenly spread, both ends included.
std::vector<std::size_t> evenly(std::size_t size, std::size_t count);
/// "12 % [8.1 % to 17 %]"; an estimate below 0 counts as 0.
std::string share_with_interval(const Estimate& share);

/// The largest finite number, at least 0.
double largest(const std::vector<double>& values);

}  // namespace glissade
