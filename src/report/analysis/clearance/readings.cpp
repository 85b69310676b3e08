// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "analysis/conditions/view.hpp"
#include "glissade/core/quantile.hpp"
#include "glissade/report/clearance_report.hpp"
#include "glissade/report/format.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

using enum ConditionAxis;

Condition shown(const Results& r) { return shown_condition(ConditionGrid(r)); }

/// The motions of a roof have no building periods.
std::string largest_mean(const Results& r) {
  return r.suites.front().of_roof ? "mean" : "largest mean over the periods";
}

/// "T = 1 s".
std::string period_text(const ConditionGrid& grid, std::size_t place) {
  return fmt::format("T = {:g} s", grid.value(period, place));
}

/// " at T = 1 s".
std::string at_period(const ConditionGrid& grid, std::size_t place) {
  return grid.results().suites.front().of_roof ? "" : " at " + period_text(grid, place);
}

/// A ratio below a thousandth is reported as that.
std::string one_ratio(double ratio) { return ratio < 1e-3 ? "below 0.001" : format_number(ratio); }

std::string ratio_text(const std::vector<double>& ratios) {
  if (ratios.empty()) return "-";
  const double median = quantile_of(ratios, 0.5);
  if (ratios.back() < 1e-3 || ratios.front() == ratios.back()) return one_ratio(median);
  return fmt::format("{} ({} to {})", one_ratio(median), one_ratio(ratios.front()),
                     one_ratio(ratios.back()));
}

double at_period(const SuiteSpectra& spectra, std::size_t p) {
  return spectra.average_g[p] / spectra.target_g[p];
}

std::string spectra_reading(const Results& r) {
  const SuiteSpectra& spectra = r.suites.front().spectra;
  if (spectra.target_g.empty()) return "";
  const auto& [lowest, highest] = spectra.to_target;
  const auto near = [&](double period) {
    return static_cast<std::size_t>(std::lround(period / 2.0 * 200.0));
  };
  std::string text = fmt::format(
      "From {:.3g} to {:.3g} s the suite's average {} spectrum is {} (at {:.3g} s) to {} times (at "
      "{:.3g} s) the target spectrum",
      spectra.range.from_s, spectra.range.to_s, spectra.combination(), format_number(lowest.ratio),
      lowest.period_s, format_number(highest.ratio), highest.period_s);
  if (spectra.periods_s.size() == 201) {
    text += fmt::format(
        "; {} at 0.1 s, {} at 0.2 s, {} at 0.7 s, {} at 1 s",
        format_number(at_period(spectra, near(0.1))), format_number(at_period(spectra, near(0.2))),
        format_number(at_period(spectra, near(0.7))), format_number(at_period(spectra, near(1.0))));
  }
  return text + ".";
}

std::string period_reading(const Results& r) {
  const MeanQuestion question;
  const ConditionGrid grid(r);
  const OrientationRange largest = over_orientations(r, question, shown(r), Periods::largest);
  const OrientationRule rule = r.clearance->orientation;
  const std::size_t period = governing_period(r, question, shown(r), rule);
  std::string text = fmt::format(
      "At {} the suite's mean is largest at {}. The largest over the periods is {}; times "
      "{:g}: a required clearance of {}",
      label_of(grid, level, shown(r)), period_text(grid, period), range_text(r, largest),
      r.clearance->factor, clearance_text(r.clearance->factor * largest.of(rule)));
  if (r.cases.orientations > 1) {
    const OrientationRule other =
        rule == OrientationRule::largest ? OrientationRule::median : OrientationRule::largest;
    text += fmt::format("{}; by the {} {}", rule_text(r), to_string(other),
                        format_length(r.clearance->factor * largest.of(other)));
  }
  text += fmt::format(". 95 % interval of the mean{}, over {}: {}.", rule_text(r), units_name(r),
                      format_length_interval(largest.interval_of(rule)));
  return text;
}

/// Which of two frictions acts down the slope.
std::string downhill_reading(const Results& r) {
  if (!has_two_frictions(r)) return "";
  std::string text;
  for (const SlopeAxis axis : {SlopeAxis::e_w, SlopeAxis::n_s}) {
    const MeanQuestion question{.slope_axis = axis};
    if (orientations_of(r, question).empty()) continue;
    const OrientationRange range = over_orientations(r, question, shown(r), Periods::largest);
    text += fmt::format(
        " Where the roof falls {}, with a friction of {:g} downhill, the {} is {}, from {} to {} "
        "over the orientations.",
        to_string(axis), ConditionGrid(r).case_at({}).friction_on(axis), largest_mean(r),
        format_length(range.median), format_length(range.lowest), format_length(range.highest));
  }
  return text;
}

std::string orientation_reading(const Results& r) {
  const MeanQuestion question;
  const PerRecordBounds own = per_record_bounds(r, question, shown(r), Periods::largest);
  const std::vector<double> means = per_record_means(r, question, shown(r), Periods::largest);
  std::string text = fmt::format(
      "With the orientation chosen record by record, the {} is from {} to {}; of 10,000 random "
      "choices 90 % give {} to {}.",
      largest_mean(r), format_length(own.lowest), format_length(own.highest),
      format_length(quantile_of(means, 0.05)), format_length(quantile_of(means, 0.95)));
  const StrongerAlong stronger = stronger_along(r, question, shown(r), Periods::largest);
  if (std::isfinite(stronger.as_recorded) && std::isfinite(stronger.reversed)) {
    text += fmt::format(
        " With every record's stronger component along the slope it is {}, and {} with that "
        "component reversed.",
        format_length(stronger.as_recorded), format_length(stronger.reversed));
  }
  text += downhill_reading(r);
  if (slides_on_two_axes(r) && r.displacement == DisplacementMeasure::srss) {
    const OrientationRange farthest =
        over_orientations(r, {.number = HistoryNumber::vector_peak}, shown(r), Periods::largest);
    text += fmt::format(
        " By the largest length of the displacement in place of the SRSS of its separate maxima: "
        "{}.",
        range_text(r, farthest));
  }
  const auto distinct = std::ranges::count_if(
      same_orientations(r), [i = CaseNumber{0}](CaseNumber same) mutable { return same == i++; });
  if (static_cast<std::size_t>(distinct) < r.cases.orientations) {
    text += fmt::format(
        " Of the {} only {} differ: a change of sign {} mirrors a history{}.", orientations_text(r),
        distinct, slides_on_two_axes(r) ? "across the slope" : "on a flat roof",
        slides_on_two_axes(r) && !has_two_frictions(r)
            ? ", and with one friction in both directions it does not matter along which of them "
              "the roof falls"
            : "");
  }
  return text;
}

std::string level_reading(const Results& r) {
  std::vector<std::string> parts;
  for (std::size_t suite = 0; suite < r.suites.size(); ++suite) {
    const OrientationRange range = over_orientations(r, {.suite = suite}, shown(r), Periods::one);
    parts.push_back(fmt::format("{} {}", r.suites[suite].name, range_text(r, range)));
  }
  const std::string building = r.suites.front().of_roof
                                   ? "The means"
                                   : "On a building of " + label_of(ConditionGrid(r), period, 0);
  return fmt::format("{}: {}.", building, fmt::join(parts, "; "));
}

std::string yielding_reading(const Results& r) {
  const ConditionGrid grid(r);
  std::vector<std::string> buildings;
  for (const Condition& building : shown_along(grid, period)) {
    const Condition reference = with_reference_strength(grid, building);
    std::vector<std::string> parts;
    for (const Condition& at : along(grid, response_modification, building)) {
      if (at[response_modification] == reference[response_modification]) continue;
      parts.push_back(fmt::format("{} ({})",
                                  ratio_text(ratios_by_orientation(r, {}, at, reference)),
                                  label_of(grid, response_modification, at)));
    }
    buildings.push_back(
        fmt::format("{}: {}", label_of(grid, period, building), fmt::join(parts, ", ")));
  }
  return fmt::format(
      "Displacement over that on {} (median over the orientations and their range). {}.",
      reference_strength_text(grid), fmt::join(buildings, "; "));
}

std::string slope_reading(const Results& r) {
  std::vector<std::string> parts;
  double flattest = 0.0, steepest = 0.0;
  const ConditionGrid grid(r);
  for (const Condition& at : shown_along(grid, slope)) {
    const OrientationRange range = over_orientations(r, {}, at, Periods::largest);
    if (at[slope] == 0) flattest = range.median;
    steepest = range.median;
    parts.push_back(
        fmt::format("{} on {}", format_length(range.median), slope_text(grid.value(slope, at))));
  }
  return fmt::format("{}: {}; {} times as much on the steepest as on the flattest.",
                     capitalised(largest_mean(r)), fmt::join(parts, ", "),
                     format_number(steepest / flattest));
}

std::string mce_reading(const Results& r) {
  const ConditionGrid grid(r);
  const std::size_t last = grid.size(level) - 1;
  Condition high;
  high[level] = last;
  const std::size_t governing = governing_period(r, {}, {}, r.clearance->orientation);
  const OrientationRange weak = over_orientations(r, {}, {}, Periods::largest),
                         first = over_orientations(r, {}, {}, Periods::one),
                         strong = over_orientations(r, {}, high, Periods::one),
                         strongest = over_orientations(r, {}, high, Periods::largest);
  const std::string low_name = label_of(grid, level, 0), high_name = label_of(grid, level, last);
  const bool of_roof = r.suites.front().of_roof;
  const auto both = [&](double low_m, const std::string& period, double high_m) {
    return fmt::format("{} at {}{}, {} at {}", format_length(low_m), low_name, period,
                       format_length(high_m), high_name);
  };
  const std::string largest =
      fmt::format("Largest over the periods: {}. At {}: ",
                  both(weak.median, " (" + period_text(grid, governing) + ")", strongest.median),
                  period_text(grid, 0));
  const std::string text =
      (of_roof ? "The mean is " : largest) + both(first.median, "", strong.median);
  if (!(weak.median > 0.0)) return text + ".";
  return text + fmt::format("; the latter is {} times {} at {}.",
                            format_number(strong.median / weak.median),
                            of_roof ? "that" : "the largest", low_name);
}

/// The largest mean over the periods for each place on an axis.
template <ConditionAxis axis>
std::string axis_reading(const Results& r) {
  std::vector<std::string> parts;
  const ConditionGrid grid(r);
  for (const Condition& at : shown_along(grid, axis)) {
    const OrientationRange range = over_orientations(r, {}, at, Periods::largest);
    parts.push_back(
        fmt::format("{}{} with {}", range_text(r, range),
                    at_period(grid, governing_period(r, {}, at, r.clearance->orientation)),
                    label_of(grid, axis, at)));
  }
  return fmt::format("{}: {}.", capitalised(largest_mean(r)), fmt::join(parts, "; "));
}

template <ConditionAxis axis>
bool several(const Results& r) {
  return ConditionGrid(r).has_several(axis);
}

struct Topic {
  bool (*is_covered)(const Results&);  ///< by a study of one suite
  std::string (*reading)(const Results&);
};

/// In the order of ClearanceTopic.
constexpr Topic topics[] = {
    {[](const Results&) { return true; }, spectra_reading},
    {several<period>, period_reading},
    {[](const Results&) { return false; }, level_reading},
    {[](const Results& r) {
       return several<response_modification>(r) &&
              ConditionGrid(r).case_at({}).response_modification == 0.0;
     },
     yielding_reading},
    {several<slope>, slope_reading},
    {several<level>, mce_reading},
    {several<vertical>, axis_reading<vertical>},
    {several<mass>, axis_reading<mass>},
    {[](const Results& r) { return r.cases.orientations > 1; }, orientation_reading}};

const Topic& topic_of(ClearanceTopic topic) { return topics[static_cast<std::size_t>(topic)]; }

}  // namespace

bool covers(const Results& results, ClearanceTopic topic) {
  return results.suites.size() > 1 ? topic == ClearanceTopic::level
                                   : topic_of(topic).is_covered(results);
}

std::string clearance_reading(const Results& results, ClearanceTopic topic) {
  if (!covers(results, topic)) return "";
  return topic_of(topic).reading(results);
}

}  // namespace glissade
