// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/fragility/assumptions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "analysis/chart/view.hpp"
#include "glissade/report/format.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

std::string building_text(const Results& results) {
  const std::vector<Case>& cases = results.cases.cases;
  const auto largest_of = [&](double Case::*quantity) {
    return std::ranges::max(cases, {}, quantity).*quantity;
  };
  if (results.suites.front().of_roof)
    return "In the motions, which are those of its roof: no building is computed.";
  if (largest_of(&Case::period_s) == 0.0) return "Rigid: the roof moves as the ground does.";
  const bool yields = !results.model.building.empty();
  const std::string model =
      results.model.modes.empty()
          ? fmt::format("A {}single-degree-of-freedom oscillator{} ({}no higher modes), one storey",
                        yields ? "" : "linear ",
                        slides_on_two_axes(results) ? " along each horizontal axis" : "",
                        yields ? "" : "no yielding, ")
          : "Linear, no yielding. It is " + results.model.modes + ",";
  return fmt::format(
      "{} with first periods of {} s and damping ratios of {}. {}{}", model,
      range_of(cases, &Case::period_s), range_of(cases, &Case::damping), results.model.building,
      largest_of(&Case::mass_ratio) == 0.0
          ? "The array's mass is neglected: it does not change the building's motion."
          : fmt::format("The array's mass acts back on it: array over building mass {}.",
                        range_of(cases, &Case::mass_ratio)));
}

/// The different values that a function of the orientation takes over the cases.
template <class Value>
std::size_t different(const std::vector<Case>& cases, Value value) {
  std::set<int> values;
  for (const Case& c : cases) {
    if (c.orientation.is_quarter_turn()) values.insert(value(c.orientation));
  }
  return values.size();
}

std::string orientation_text(const Results& results) {
  const CaseSet& set = results.cases;
  const bool two_axes = slides_on_two_axes(results);
  const std::string acts = two_axes ? "Both horizontal components act at once. "
                                    : "One horizontal component acts along the slope; motion "
                                      "across the slope is not combined with it. ";
  if (set.orientations > 1) {
    return acts + fmt::format("Every record is run in {} orientations: {} ...", set.orientations,
                              to_string(set.cases[0].orientation));
  }
  const auto along = [](const Orientation& o) { return along_axis(o, 0).component; };
  const auto sign = [](const Orientation& o) { return along_axis(o, 0).sign; };
  const auto text = [](std::size_t values) {
    return values > 1 ? "drawn for each sample" : "the same throughout";
  };
  return acts + fmt::format("Which component acts along the {} is {}; its sign is {}.",
                            two_axes ? "building's first axis" : "slope",
                            text(different(set.cases, along)), text(different(set.cases, sign)));
}

std::string vertical_text(const std::vector<RecordSummary>& records) {
  const auto with =
      std::count_if(records.begin(), records.end(), [](const auto& r) { return r.has_vertical; });
  return fmt::format(
      "With a vertical component: {} of {}. Where the study uses it, it changes the normal "
      "force and with it the friction; where the normal force would fall below zero the history is "
      "flagged as uplift, which is outside the model.",
      with, counted(records.size(), "record"));
}

/// The unit of the intervals.
Assumption independence(const Results& results) {
  const std::string name = units_name(results);
  return {"Independence",
          (name == "events" ? counted_records(results) +
                                  "; events are the independent unit, also across suites. "
           : results.histories.unit_of.empty()
               ? "Records are taken as independent; the suite states no events. "
               : "Records are the independent unit, each of an event of its own. ") +
              (results.by_stripes ? "A motion that is in several stripes is one unit. " : "") +
              "Intervals are from the variance between " + name + ", so few " + name +
              " give wide intervals however many samples there are."};
}

/// What a reader takes from the numbers: fragilities, or a chart.
std::vector<Assumption> reading_assumptions(const Results& results) {
  if (results.chart) {
    return {{"Design displacement",
             clearance_rule(results) +
                 ": a recommendation, not a bound, as single motions give more slip. Percentiles "
                 "are over records. Each is the largest over the building periods. Of one record "
                 "there is neither: its peak slip is shown."},
            independence(results),
            {"Interpolation",
             "Linear in slope and friction between the chart's points; none between levels, and "
             "nothing beyond the axes."}};
  }
  if (results.by_stripes)
    return {{"Stripes",
             "Each level has records of its own, which represent the motions of that level. Curves "
             "are fitted to the shares that exceed, by the binomial likelihood (Baker 2015); no "
             "record has a capacity."},
            independence(results)};
  return {
      {"Capacity",
       "The lowest intensity at which the slip first reaches the clearance. Slip does not always "
       "grow with intensity; the share that falls below again is given as 'recross'."},
      independence(results)};
}

std::string roof_text(const Results& results) {
  return "A plane with a slope of " + range_of(results.cases.cases, &Case::slope_deg) + " degrees.";
}

}  // namespace

std::vector<Assumption> assumptions_of(const Results& results) {
  std::vector<Assumption> all = {
      {"Model", results.model.kernel + "."},
      {"Displacement",
       "In plan (measured horizontally), relative to the roof; the largest absolute value in the "
       "history, not the one that remains at its end. " +
           results.model.displacement},
      {"Array",
       "A rigid block without attachment: no flexing of the array, no wind, no wiring or parapet "
       "that stops it."},
      {"Friction", results.model.friction.empty()
                       ? "Coulomb: one coefficient for sticking and sliding, independent of speed, "
                         "pressure and wear. No bond that must first break."
                       : results.model.friction + "It does not depend on pressure or wear."},
      {"Roof", roof_text(results)},
      {"Building", building_text(results)},
      {"Orientation",
       orientation_text(results) +
           (results.chart ? " In the chart each record counts once, with the largest of them."
                          : "")},
      {"Vertical motion", vertical_text(results.records)},
      {"End of the record",
       "After its last sample the acceleration goes linearly to zero over one more interval and "
       "stays there; the building rings down and the array coasts until it stops."},
  };
  const std::vector<Assumption> reading = reading_assumptions(results);
  all.insert(all.end(), reading.begin(), reading.end());
  return all;
}

}  // namespace glissade
