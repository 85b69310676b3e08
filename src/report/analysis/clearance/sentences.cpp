// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "analysis/conditions/columns.hpp"
#include "analysis/conditions/view.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/report/clearance_report.hpp"
#include "glissade/report/format.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

std::string what_was_run(const Results& r) {
  std::vector<std::string> suites;
  for (const SuiteSummary& suite : r.suites) suites.push_back(suite.name);
  const auto without = std::ranges::count_if(
      r.records, [](const RecordSummary& record) { return !record.has_vertical; });
  const ConditionGrid grid(r);
  std::string text = fmt::format("{}, {} of {}", counted(grid.count(), "condition"),
                                 counted_records(r), fmt::join(suites, ", "));
  if (r.cases.orientations > 1) text += fmt::format(", {}", orientations_text(r));
  const Condition shown = shown_condition(grid);
  text += fmt::format(". Shown, where nothing else is stated: {}.", conditions_text(r, shown));
  if (grid.has_several(ConditionAxis::level))
    text += fmt::format(" Of the {} levels this is {}.", grid.size(ConditionAxis::level),
                        shown[ConditionAxis::level] + 1 == grid.size(ConditionAxis::level)
                            ? "the highest"
                            : "the design earthquake");
  if (without > 0)
    text += fmt::format(" No vertical component: {}.",
                        counted(static_cast<std::size_t>(without), "record"));
  const double uplift = uplift_share(r);
  if (uplift > 0.0)
    text += fmt::format(
        " In {} of the histories of all conditions the array lifts off, which is outside the "
        "model.",
        format_share(uplift));
  return text;
}

/// Not the rule of a chart, which takes of each record the orientation that slides farthest.
std::string clearance_rule_text(const Results& r) {
  const bool several = r.cases.orientations > 1;
  const std::string orientation =
      several ? fmt::format(" with all records in the same orientation{} (clearance.orientation)",
                            rule_text(r))
              : "";
  std::string theirs = r.clearance->factor == ClearanceConfig{}.factor ? "" : "1.1";
  if (several && r.clearance->orientation == OrientationRule::largest)
    theirs += theirs.empty() ? "the median" : ", the median";
  return fmt::format("Required clearance: {:g} x the suite's mean{}{} (Walters et al. 2012{}{}).",
                     r.clearance->factor, orientation, over_building_periods(r),
                     theirs.empty() ? "" : ": ", theirs);
}

/// The smallest and the largest clearance of all conditions in which the array may slide.
std::string range_of_conditions(const Results& r) {
  const ConditionGrid grid(r);
  const std::vector<Condition> places = sliding_conditions(grid, Periods::largest);
  const std::vector<RequiredClearance>& required = r.clearance->required;
  std::vector<std::pair<double, std::string>> clearances;
  for (std::size_t i = 0; i < required.size(); ++i) {
    clearances.emplace_back(
        std::isfinite(required[i].clearance_m) ? required[i].clearance_m : infinity,
        (r.suites.size() > 1 ? r.suites[required[i].largest.suite].name + ", " : std::string()) +
            distinguished(grid, places[i % places.size()],
                          {ConditionAxis::period, ConditionAxis::support}));
  }
  if (clearances.size() < 2) return "";
  const auto [least, most] = std::ranges::minmax_element(clearances);
  return fmt::format("Over all conditions the clearance is from {} ({}) to {} ({}).",
                     clearance_text(least->first), least->second, clearance_text(most->first),
                     most->second);
}

}  // namespace

std::vector<std::string> clearance_sentences(const Results& results) {
  std::vector<std::string> sentences{clearance_rule_text(results), what_was_run(results)};
  for (const ClearanceTopic topic :
       {ClearanceTopic::period, ClearanceTopic::orientation, ClearanceTopic::mass,
        ClearanceTopic::level, ClearanceTopic::yielding, ClearanceTopic::slope, ClearanceTopic::mce,
        ClearanceTopic::vertical, ClearanceTopic::spectra}) {
    const std::string reading = clearance_reading(results, topic);
    if (!reading.empty()) sentences.push_back(reading);
  }
  if (const std::string range = range_of_conditions(results); !range.empty())
    sentences.push_back(range);
  return sentences;
}

namespace {

/// The condition, the governing period and the clearance, for a terminal.
Table brief_clearance_table(const Results& results) {
  Table table = clearance_table(results);
  const std::size_t conditions = ConditionColumns(results).count();
  const std::string other = results.clearance->orientation == OrientationRule::largest
                                ? "clearance_median"
                                : "clearance_highest";
  std::vector<std::string> others;
  for (std::size_t i = conditions; i < table.columns.size(); ++i) {
    const std::string& stem = table.columns[i].stem;
    if (stem != "governing_period" && stem != "clearance" && stem != other) others.push_back(stem);
  }
  for (const std::string& stem : others) table = table.without(stem);
  table.notes.clear();  // of the columns that are left out
  const std::string one_axis = one_axis_text(results);
  table.title = "Required clearance by condition" + rule_text(results) +
                (one_axis.empty() ? "" : ", along " + one_axis);
  return table.first_rows(24, "clearances");
}

}  // namespace

std::string clearance_summary(const Results& results) {
  return to_text(brief_clearance_table(results)) + "\n" + paragraphs(clearance_sentences(results));
}

}  // namespace glissade
