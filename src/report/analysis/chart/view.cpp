// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/chart/view.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "glissade/report/format.hpp"
#include "glissade/standards/conditions.hpp"
#include "text/study_text.hpp"

namespace glissade {

bool is_one_record(const Results& results) { return results.records.size() == 1; }

double clearance_factor(const Results& results) {
  return results.clearance ? results.clearance->factor : ClearanceConfig{}.factor;
}

std::string design_name(const Results& results) {
  if (is_one_record(results)) return "peak slip";
  return results.measure.is_of_design_spectrum()
             ? "design displacement"
             : fmt::format("{:g} x mean slip", clearance_factor(results));
}

std::string design_title(const Results& results) { return capitalised(design_name(results)); }

std::string shown_title(const Results& results) {
  return is_one_record(results)
             ? "Peak slip under the record " + results.records.front().id
             : fmt::format("{:g} x the largest mean displacement", clearance_factor(results));
}

std::string clearance_rule(const Results& results) {
  const double factor = clearance_factor(results);
  return fmt::format(
      "{:g} x the mean over the records, each in {} (factor: Walters et al. 2012{})", factor,
      results.cases.orientations > 1 ? "the orientation that slides farthest" : "its orientation",
      factor == ClearanceConfig{}.factor ? "" : ": 1.1");
}

ChartStatistic design_statistic(const Results& results) { return chart_statistics(results)[0]; }

std::vector<ChartStatistic> chart_statistics(const Results& results) {
  const bool pooled = results.cases.samples > 1;
  const ChartStatistic largest = {"envelope", pooled ? "Largest history" : "Largest record",
                                  pooled ? "largest history" : "largest record",
                                  [](const ChartPoint& p) { return p.largest.envelope_m; },
                                  &ChartReading::envelope};
  if (is_one_record(results)) {
    ChartStatistic peak = largest;
    peak.stem = "peak_slip";
    peak.heading = "Peak slip of the record";
    return {peak};
  }
  const bool is_design = results.measure.is_of_design_spectrum();
  return {
      {is_design ? "clearance" : "factored_mean_slip",
       is_design ? fmt::format("{} ({:g} x mean)", design_title(results), clearance_factor(results))
                 : design_title(results),
       design_name(results), [](const ChartPoint& p) { return p.clearance_m; },
       &ChartReading::clearance},
      {"mean_slip", "Mean over records", "mean",
       [](const ChartPoint& p) { return p.largest.mean_m; }, &ChartReading::mean},
      {"p84_slip", "84th percentile", "84th percentile",
       [](const ChartPoint& p) { return p.largest.p84_m; }, &ChartReading::p84},
      {"p95_slip", "95th percentile", "95th percentile",
       [](const ChartPoint& p) { return p.largest.p95_m; }, &ChartReading::p95},
      largest};
}

std::size_t nearest(const std::vector<double>& axis, double value) {
  const auto found = std::min_element(axis.begin(), axis.end(), [&](double a, double b) {
    return std::abs(a - value) < std::abs(b - value);
  });
  return static_cast<std::size_t>(found - axis.begin());
}

const ChartPoint& shown_point(const Results& results) {
  const Chart& chart = *results.chart;
  return chart.at(nearest(results.levels, chart.shown_level),
                  nearest(chart.slope_deg, chart.shown_slope_deg),
                  nearest(chart.mu, chart.shown_mu));
}

std::vector<std::size_t> spread(std::size_t size, std::size_t count) {
  std::vector<std::size_t> chosen;
  const std::size_t step = std::max<std::size_t>(1, (size + count - 3) / (count - 1));
  for (std::size_t i = 0; i + 1 < size; i += step) chosen.push_back(i);
  chosen.push_back(size - 1);
  return chosen;
}

std::string brief(double value) { return fmt::format("{:.4g}", value); }

std::string degrees(double slope_deg) {
  return brief(slope_deg) + (slope_deg == 1.0 ? " degree" : " degrees");
}

std::string at_slope_and_friction(double slope_deg, double mu) {
  return fmt::format("a slope of {} and a coefficient of friction of {}", degrees(slope_deg),
                     brief(mu));
}

std::string chart_size(const Results& results) {
  const Chart& chart = *results.chart;
  const std::size_t histories =
      results.records.size() * results.cases.size() * results.levels.size();
  return fmt::format(
      "{} x {} x {} x {} of {}: {} from {} histories", counted(chart.slope_deg.size(), "slope"),
      counted(chart.mu.size(), "coefficient") + " of friction",
      counted(chart.period_s.size(), "building period"), counted(results.levels.size(), "level"),
      results.intensity_label, counted(chart.points.size(), "point"), histories);
}

namespace {

/// What the chart has no axis for: it takes the largest over it.
std::string largest_over(const Results& results) {
  std::vector<std::string> listed;
  for (const CaseAxis& axis : results.cases.axes) {
    if (axis.key == "roof.slope_deg" || axis.key == "friction.mu" ||
        axis.key == "building.period_s" || axis.key == "friction.value" ||
        axis.key == "array.support")
      continue;
    listed.push_back(axis.words());
  }
  std::vector<std::string> largest;
  if (results.cases.orientations > 1) largest.emplace_back("the orientation that slides farthest");
  if (!listed.empty())
    largest.push_back(
        fmt::format("the largest over the listed values of {}", fmt::join(listed, " and of ")));
  return fmt::format("{}", fmt::join(largest, " and "));
}

/// "mean 0.549, standard deviation 0.041" over the samples.
std::string moments_over_samples(const CaseSet& set, double Case::*of) {
  double count = 0.0, mean = 0.0, squares = 0.0;
  for (const Case& c : set.cases) {
    if (c.friction_value != FrictionValue::as_drawn ||
        c.orientation.slope_axis != set.cases.front().orientation.slope_axis)
      continue;
    const double before = c.*of - mean;
    mean += before / ++count;
    squares += before * (c.*of - mean);
  }
  return fmt::format("mean {:.3g}, standard deviation {:.3g}", mean, std::sqrt(squares / count));
}

/// How friction is drawn, where it is.
std::string drawn_friction(const Results& results) {
  const CaseSet& set = results.cases;
  const auto varies = [&](double Case::*of) {
    return std::ranges::any_of(set.cases, [&](const Case& c) {
      return c.friction_value == FrictionValue::as_drawn && c.*of != set.cases.front().*of;
    });
  };
  if (set.axis("friction.mu") < set.axes.size() || !varies(&Case::friction)) return "";
  return fmt::format(
      " Friction is drawn for each sample ({}): {}{}. The friction in the chart is the "
      "mean.",
      counted(set.samples, "sample"), moments_over_samples(set, &Case::friction),
      slides_on_two_axes(results)
          ? "; across the slope " + moments_over_samples(set, &Case::friction_across)
          : "");
}

}  // namespace

std::string how_counted(const Results& results) {
  const std::vector<double>& periods = results.chart->period_s;
  const std::size_t samples = results.cases.samples;
  const std::string model =
      results.model.modes.empty() ? "one mass: one storey" : results.model.modes;
  const std::string building =
      periods.size() > 1
          ? fmt::format("the largest over {} building periods from {} to {} s ({})", periods.size(),
                        brief(periods.front()), brief(periods.back()), model)
      : results.suites.front().of_roof ? "on the motions of the roof"
      : periods.front() == 0.0
          ? "on a rigid building"
          : fmt::format("for a building period of {} s ({})", brief(periods[0]), model);
  const std::string largest = largest_over(results);
  const std::string of_each = largest.empty() ? "in its orientation" : "with " + largest;
  if (is_one_record(results)) {
    return fmt::format("The peak slip of the one record {}, {}{}, {}; in plan.",
                       results.records.front().id, of_each,
                       samples > 1 ? fmt::format(", the largest of {} samples", samples) : "",
                       building) +
           drawn_friction(results);
  }
  std::string text = fmt::format(
      "{}, each counted {}; {}; {}; in plan.", counted_records(results), of_each, building,
      slides_on_two_axes(results) ? "both horizontal components, along and across the slope"
                                  : "one horizontal component along the slope");
  if (samples > 1) {
    text += fmt::format(
        " Of each record {} samples are run: a mean is over the records' means; percentiles and "
        "the largest are over records and samples pooled, which are not independent.",
        samples);
  }
  return text + drawn_friction(results);
}

std::string limits_of(Standard standard) {
  return fmt::format("slopes of {:.3g} degrees or less and friction of {:g} or more (recalled)",
                     slope_limit_deg(standard), friction_limit(standard));
}

bool applies_at(Standard standard, double slope_deg, double mu) {
  return is_within(standard, {.slope_deg = slope_deg, .friction = mu});
}

double PrescribedLine::slope_limit() const {
  return slope_limit_deg(*std::ranges::max_element(standards, {}, slope_limit_deg));
}

double PrescribedLine::mu_limit() const {
  return friction_limit(*std::ranges::min_element(standards, {}, friction_limit));
}

std::string PrescribedLine::names() const {
  std::string names;
  for (const Standard standard : standards)
    names += (names.empty() ? "" : " and ") + standard_name(standard);
  return names;
}

std::string PrescribedLine::label() const {
  return names() + ": " + format_length(value_m) +
         (provenance == Provenance::recalled ? " (recalled: verify)" : "");
}

Look prescribed_look(const PrescribedLine& line) {
  Look style = look(Role::prescribed);
  style.width = 3.5;
  style.dash = line.only(Standard::asce7_16) ? 3 : 2;
  return style;
}

std::vector<PrescribedLine> prescribed_at(const Chart& chart, double level) {
  std::vector<PrescribedLine> lines;
  for (const ChartPrescription& p : chart.standards) {
    if (p.sds_g != level) continue;
    const auto same = std::find_if(lines.begin(), lines.end(), [&](const PrescribedLine& line) {
      return std::abs(line.value_m - p.prescribed.value_m) < 1e-9;  // inches and feet round apart
    });
    PrescribedLine& line =
        same != lines.end() ? *same : lines.emplace_back(PrescribedLine{p.prescribed.value_m});
    line.standards.push_back(p.standard);
    if (p.prescribed.provenance == Provenance::recalled) line.provenance = Provenance::recalled;
  }
  return lines;
}

std::optional<double> prescribed_m(const Chart& chart, Standard standard, double level) {
  for (const ChartPrescription& p : chart.standards) {
    if (p.standard == standard && p.sds_g == level) return p.prescribed.value_m;
  }
  return std::nullopt;
}

std::vector<Standard> standards_of(const Chart& chart) {
  std::vector<Standard> found;
  for (const ChartPrescription& p : chart.standards) {
    if (std::count(found.begin(), found.end(), p.standard) == 0) found.push_back(p.standard);
  }
  return found;
}

}  // namespace glissade
