// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/study_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>

#include "glissade/core/finite.hpp"
#include "glissade/report/format.hpp"

namespace glissade {

std::string in_plan(const Results& results) {
  const std::string one_axis = one_axis_text(results);
  return "Displacements are in plan (horizontal)" +
         (one_axis.empty() ? "." : ", along " + one_axis + ".");
}

std::string one_axis_text(const Results& results) {
  return slides_on_two_axes(results) ? "" : "one axis only (model.axes = 1)";
}

bool differs_by_suite(const Results& results) {
  return std::ranges::any_of(results.suites, [&](const SuiteSummary& suite) {
    return suite.target != results.suites.front().target;
  });
}

std::string target_text(const Results& results, std::optional<std::size_t> suite) {
  const bool counts =
      results.measure.is_of_design_spectrum() || !results.model.building.empty();  // or it yields
  if (!counts || results.suites.empty()) return "";
  if (!differs_by_suite(results)) return results.suites.front().target;
  return suite ? results.suites[*suite].target : "differs by suite";
}

std::string with_unit(const Results& results, const std::string& value) {
  const std::string unit = results.measure.unit();
  return unit == "-" ? value : value + " " + unit;
}

std::string at_intensity(const Results& results, double value) {
  const std::string name = earthquake_name(value, results.model.dbe_level);
  return results.intensity_symbol + " = " + with_unit(results, level_number(value)) +
         (name.empty() ? "" : " (" + name + ")");
}

std::string level_number(double level) {
  const std::string four = fmt::format("{:.4g}", level);
  const bool is_given_so = level > 0.0 && std::abs(rounded_to(level, 4) / level - 1.0) < 1e-12;
  return is_given_so && four.size() > format_number(level).size() ? four : format_number(level);
}

Column intensity_column(const Results& results, const std::string& stem, const std::string& heading,
                        const std::string& description) {
  const std::string unit = results.measure.unit(), suffix = unit_suffix(unit);
  return {stem, suffix.empty() ? "" : suffix.substr(1), heading + (unit == "-" ? "" : ", " + unit),
          ColumnKind::number, description};
}

Column listed_column(const CaseAxis& axis) {
  const std::size_t dot = axis.key.find('.');
  std::string stem = axis.key.substr(dot + 1), heading = capitalised(axis.words());
  const std::string table = axis.key.substr(0, dot);
  if (stem == "value" || stem == "use")
    stem = table;
  else if (table == "vertical")
    stem = table + "_" + stem;  // the building has the same keys
  const std::string description = axis.words();
  if (!axis.names.empty()) return text_column(stem, heading, description);
  if (axis.unit == "-") return {stem, "", heading, ColumnKind::number, description};
  const std::string suffix = "_" + axis.unit;
  if (stem.ends_with(suffix)) stem.resize(stem.size() - suffix.size());
  return {stem, axis.unit, heading + ", " + axis.unit, ColumnKind::number, description};
}

Column listed_column(const Parameter& parameter) {
  return listed_column(CaseAxis{parameter.name(), parameter.unit, {}, {}, {}});
}

bool lists_more_than_friction_value(const Results& results) {
  const std::vector<CaseAxis>& axes = results.cases.axes;
  return axes.size() > 1 || (axes.size() == 1 && axes.front().key != "friction.value");
}

Table with_listed(const Results& results, const Table& table) {
  const std::vector<CaseAxis>& axes = results.cases.axes;
  Table listed = table;
  if (!lists_more_than_friction_value(results)) {  // the label says it
    listed.columns.front().heading = "Friction";
    return listed;
  }
  std::map<std::string, std::vector<Cell>> cells;
  for (const RunResults& run : results.runs) {
    const std::vector<std::size_t> place = results.cases.places(combination_of(results, run));
    for (std::size_t i = 0; i < axes.size(); ++i)
      cells[run.label].push_back(axes[i].names.empty() ? Cell(axes[i].values[place[i]])
                                                       : Cell(axes[i].names[place[i]]));
  }
  for (std::size_t i = 0; i < axes.size(); ++i)
    listed.columns.insert(listed.columns.begin() + 1 + static_cast<std::ptrdiff_t>(i),
                          listed_column(axes[i]));
  for (std::vector<Cell>& row : listed.rows) {
    const std::vector<Cell>& of_run = cells.at(std::get<std::string>(row.front()));
    row.insert(row.begin() + 1, of_run.begin(), of_run.end());
  }
  return listed;
}

Table without_run_key(const Results& results, const Table& table) {
  return lists_more_than_friction_value(results) ? table.without(table.columns.front().stem)
                                                 : table;
}

std::string counts_of(const Results& results) {
  return counted_records(results) + " x " + counted(results.cases.samples, "sample");
}

std::string units_name(const Results& results) {
  return unit_count(results) < results.records.size() ? "events" : "records";
}

std::string counted_records(const Results& results) {
  const std::size_t units = unit_count(results), records = results.records.size();
  return counted(records, "record") + (units < records ? " of " + counted(units, "event") : "");
}

std::string open_percentile(const Results& results) {
  return open_percentile(static_cast<std::size_t>(effective_units(results)), units_name(results));
}

std::string levels_of_each(const Results& results) {
  return (results.by_stripes ? "1 of " : "") + counted(results.levels.size(), "level");
}

std::size_t combination_of(const Results& results, const RunResults& run) {
  return run.first_case / std::max<std::size_t>(1, results.cases.per_combination());
}

const SlipStatistics* slip_at(const RunResults& run, double level) {
  const auto found = std::ranges::find(run.slip, level, &SlipStatistics::level);
  return found == run.slip.end() ? nullptr : &*found;
}

std::string run_name(const Results& results, const RunResults& run) {
  const std::string listed = results.cases.describe(combination_of(results, run));
  return listed.empty() ? run.label + " friction" : listed;
}

std::string governing_text(const Results& results) {
  const RunResults& run = results.runs[governing_run(results)];
  if (!lists_more_than_friction_value(results)) return "friction " + run.friction;
  return "the combination that exceeds the clearances most often overall (" +
         run_name(results, run) + ")";
}

namespace {
constexpr std::size_t most_friction = 60;  // characters in a line of several things
}  // namespace

std::string friction_and_listed(const Results& results, const RunResults& run) {
  const std::string listed =
      results.cases.describe(combination_of(results, run), {"friction.value"});
  return listed.empty() ? run.friction : run.friction + "; " + listed;
}

std::string friction_of(const Results& results, const RunResults& run) {
  const std::string in_full = friction_and_listed(results, run);
  return in_full.size() <= most_friction ? "friction " + in_full : run_name(results, run);
}

namespace {

/// "1.19 to 4.76": what a number of the cases is, whatever its sign; empty where it is 0.
std::string range_of(const Results& results, CaseSlice cases, double Case::*of) {
  double low = infinity, high = 0.0;
  for (std::size_t i = cases.first; i < cases.first + cases.count; ++i) {
    const double value = std::round(1e3 * std::abs(results.cases.cases[i].*of)) / 1e3;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (high == 0.0) return "";
  return (low == high ? "" : fmt::format("{:.3g} to ", low)) + fmt::format("{:.3g}", high);
}

/// Stated by cases_below(), or as the friction.
bool is_of_cases_below(const std::string& key) {
  return key.starts_with("friction.") || key == "roof.slope_deg" || key == "building.period_s" ||
         key == "building.mass_ratio";
}

}  // namespace

std::string cases_below(const Results& results, CaseSlice cases) {
  const std::vector<SuiteSummary>& all = results.suites;
  const std::string suites = all.front().name + (all.size() == 1   ? ""
                                                 : all.size() == 2 ? ", " + all.back().name
                                                                   : " to " + all.back().name);
  const std::string slope = range_of(results, cases, &Case::slope_deg),
                    periods = range_of(results, cases, &Case::period_s),
                    ratio = range_of(results, cases, &Case::mass_ratio);
  return suites + ", " + counts_of(results) + "; " +
         (slope.empty() ? "flat roof" : "slope " + slope + " degrees") + ", " +
         (results.suites.front().of_roof ? "motions of the roof"
          : periods.empty()              ? "rigid building"
                                         : "buildings of T " + periods + " s" +
                                  (results.model.modes.empty() ? "" : " with several modes")) +
         (ratio.empty() ? "" : ", m/M " + ratio);
}

std::string range_of(const std::vector<Case>& cases, double Case::*quantity, double scale) {
  const auto [low, high] = std::ranges::minmax(cases, {}, quantity);
  const std::string first = fmt::format("{:.3g}", scale * low.*quantity);
  return low.*quantity == high.*quantity
             ? first
             : fmt::format("{} to {:.3g}", first, scale * high.*quantity);
}

std::string run_below(const Results& results, const RunResults& run) {
  std::string text = cases_below(results, slice_of(run)) + "; ";
  if (run.friction.size() > most_friction) return text + run_name(results, run);
  text += "friction " + run.friction;
  const std::vector<std::size_t> place = results.cases.places(combination_of(results, run));
  for (std::size_t i = 0; i < place.size(); ++i) {
    const CaseAxis& axis = results.cases.axes[i];
    if (!is_of_cases_below(axis.key)) text += "; " + axis.describe(place[i]);
  }
  return text;
}

std::vector<double> some_levels(const std::vector<double>& levels, std::size_t count) {
  const std::size_t steps = std::min(count, levels.size());
  std::vector<double> chosen;
  for (std::size_t i = 1; i <= steps; ++i) chosen.push_back(levels[i * levels.size() / steps - 1]);
  return chosen;
}

std::vector<std::size_t> evenly(std::size_t size, std::size_t count) {
  std::vector<std::size_t> chosen;
  const std::size_t most = std::min(size, count);
  for (std::size_t i = 0; i < most; ++i)
    chosen.push_back(most < 2 ? i : i * (size - 1) / (most - 1));
  return chosen;
}

std::string share_with_interval(const Estimate& share) {
  return fmt::format("{} [{} to {}]", format_share(std::max(0.0, share.value)),
                     format_share(share.interval.low), format_share(share.interval.high));
}

double largest(const std::vector<double>& values) {
  double found = 0.0;
  for (const double value : values)
    if (std::isfinite(value)) found = std::max(found, value);
  return found;
}

}  // namespace glissade
