// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/fragility/assumptions.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "glissade/report/format.hpp"

namespace glissade {
namespace {

template <class T>
struct Range {
  T min{}, max{};
  bool is_one_value() const { return min == max; }
};

template <class T>
Range<T> range_of(const std::vector<SamplePoint>& samples, T SamplePoint::*member) {
  if (samples.empty()) return {};
  Range<T> range{samples.front().*member, samples.front().*member};
  for (const SamplePoint& sample : samples) {
    range.min = std::min(range.min, sample.*member);
    range.max = std::max(range.max, sample.*member);
  }
  return range;
}

std::string range_text(const Range<double>& range, const std::string& unit) {
  const std::string high = format_number(range.max) + unit;
  return range.is_one_value() ? high : format_number(range.min) + " to " + high;
}

std::string building_text(const Results& results) {
  const std::vector<SamplePoint>& samples = results.samples;
  const Range<double> period = range_of(samples, &SamplePoint::period_s);
  if (period.max == 0.0) return "Rigid: the roof moves as the ground does.";
  const bool yields = !results.model.building.empty();
  const Range<double> mass = range_of(samples, &SamplePoint::mass_ratio);
  return fmt::format(
      "A {}single-degree-of-freedom oscillator{} ({}no higher modes) with {}"
      "periods of {} and damping ratios of {}. {}{}",
      yields ? "" : "linear ", slides_on_two_axes(results) ? " along each horizontal axis" : "",
      yields ? "" : "no yielding, ", results.chart ? "" : "sampled ", range_text(period, " s"),
      range_text(range_of(samples, &SamplePoint::damping), ""), results.model.building,
      mass.max == 0.0
          ? "The array's mass is neglected: it does not change the building's motion."
          : fmt::format("The array's mass acts back on it: array over building mass {}.",
                        range_text(mass, "")));
}

std::string drawn_or_fixed(const Range<int>& sign) {
  return sign.is_one_value() ? fmt::format("always {}", sign.min > 0 ? "positive" : "negative")
                             : "drawn for each sample";
}

std::string two_axis_orientation_text(const Results& results) {
  const std::vector<SamplePoint>& samples = results.samples;
  const Range<int> component = range_of(samples, &SamplePoint::component);
  return fmt::format(
      "Both horizontal components act at once. The one along the building's first axis is {}; its "
      "sign is {}, that of the other {}. The roof falls {} degrees from that axis.",
      component.is_one_value() ? (component.min == 0 ? "the record's first" : "the record's second")
                               : "drawn for each sample",
      drawn_or_fixed(range_of(samples, &SamplePoint::sign)),
      drawn_or_fixed(range_of(samples, &SamplePoint::second_sign)),
      range_text(range_of(samples, &SamplePoint::azimuth_deg), ""));
}

std::string orientation_text(const std::vector<SamplePoint>& samples) {
  const Range<int> component = range_of(samples, &SamplePoint::component);
  const Range<int> sign = range_of(samples, &SamplePoint::sign);
  return fmt::format(
      "One horizontal component acts along the slope; motion across the slope is not combined with "
      "it. {} {}",
      component.is_one_value() ? fmt::format("It is always the {} component of the record.",
                                             component.min == 0 ? "first" : "second")
                               : "Which of the two components it is, is drawn for each sample.",
      sign.is_one_value()
          ? fmt::format("Its sign is always {}.", sign.min > 0 ? "positive" : "negative")
          : "Its sign (which way is downslope) is drawn for each sample.");
}

std::string vertical_text(const std::vector<RecordSummary>& records) {
  const auto with =
      std::count_if(records.begin(), records.end(), [](const auto& r) { return r.has_vertical; });
  return fmt::format(
      "{} of {} records have a vertical component. Where the study uses it, it changes the normal "
      "force and with it the friction; where "
      "the normal force would fall below zero the history is flagged as uplift, which is outside "
      "the model.",
      with, records.size());
}

std::string chart_orientation_text(const Results& results) {
  const Range<int> component = range_of(results.samples, &SamplePoint::component);
  const bool both_ways = !range_of(results.samples, &SamplePoint::sign).is_one_value() ||
                         range_of(results.samples, &SamplePoint::slope_deg).min < 0.0;
  return fmt::format(
      "{} Each record counts once, with the largest slip of its orientations: {}, {} along the "
      "slope.",
      slides_on_two_axes(results)
          ? "Both horizontal components act at once, along and across the slope."
          : "One horizontal component acts along the slope; motion across the slope is not "
            "combined "
            "with it.",
      component.is_one_value()
          ? fmt::format("its {} component", component.min == 0 ? "first" : "second")
          : "both components in turn",
      both_ways ? "either way" : "one way");
}

/// What a reader takes from the numbers: fragilities, or a chart.
std::vector<Assumption> reading_assumptions(const Results& results) {
  if (results.chart) {
    return {
        {"Clearance",
         "1.1 x the mean over the records (Walters et al. 2012): a recommendation, not a bound, "
         "as single motions slide farther. Percentiles are over records. Each is the largest "
         "over the building periods. Of one record there is neither: its peak slip is shown."},
        {"Interpolation",
         "Linear in slope and friction between the chart's points; none between levels, and "
         "nothing beyond the axes."}};
  }
  return {
      {"Capacity",
       "The lowest intensity at which the slip first reaches the clearance. Slip does not always "
       "grow with intensity; the share that falls below again is given as 'recross'."},
      {"Independence",
       "Records are the independent unit. Intervals come from resampling whole records, so a suite "
       "of few records gives wide intervals however many samples there are."}};
}

std::string roof_text(const Results& results) {
  if (results.chart) return "A plane; its slope is an axis of the chart.";
  return "A plane with a slope of " +
         range_text(range_of(results.samples, &SamplePoint::slope_deg), " degrees") +
         " in the samples.";
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
                         "pressure and "
                         "wear. No bond that must first break."
                       : results.model.friction + "It does not depend on pressure or wear."},
      {"Roof", roof_text(results)},
      {"Building", building_text(results)},
      {"Orientation", results.chart                 ? chart_orientation_text(results)
                      : slides_on_two_axes(results) ? two_axis_orientation_text(results)
                                                    : orientation_text(results.samples)},
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
