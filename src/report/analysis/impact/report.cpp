// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/analyses.hpp"
#include "glissade/report/figures.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/tables.hpp"
#include "page/page.hpp"
#include "plot/view.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

bool has_impact(const Results& results) {
  return std::ranges::any_of(results.runs,
                             [](const RunResults& run) { return !run.impact.empty(); });
}

/// Kinetic energy of what moves at a speed, by its mass.
auto energy_jpkg(Estimate ImpactStatistics::*mps) {
  return [=](const ImpactStatistics& s) { return 0.5 * (s.*mps).value * (s.*mps).value; };
}

/// How to read any of it, in plain words.
std::string impact_explained() {
  return "Each number is conditional on impact: histories that do not reach the "
         "clearance are left out, and the share that reaches it is given beside it. The speed is "
         "that of the array relative to the roof, in plan, when it is first displaced by the "
         "clearance. The kinetic energy (J) of each kilogram that moves together is half the "
         "square of the speed; a parapet there must absorb it. The histories slide on as if "
         "nothing stood there: a parapet that stops the array changes what follows.";
}

constexpr std::size_t most_levels = 3;

/// Enough records reach it for intervals; percentiles of fewer would be of those records alone.
bool reached_by_enough(double low_mps) { return !std::isnan(low_mps); }

}  // namespace

Table impact_table(const Results& results) {
  using S = ImpactStatistics;
  TableOf<RunResults, S> t(
      "impact", "Speed and time at which the array is first displaced by a clearance. " +
                    impact_explained() + " Intensity measure: " + results.intensity_label + ".");
  t.put_all(run_column, threshold_column, level_column(results));
  t.share("reached_share", "Reached", "share of histories that reach the threshold",
          &S::reached_share);
  const std::string speed = " of the speed at the first crossing";
  t.number("p16_speed", "16th percentile", "16th percentile" + speed, &S::speed_p16_mps, "mps");
  t.number("median_speed", "Median speed",
           "median speed in plan at the first crossing, of the histories that reach it",
           &S::speed_median_mps, "mps");
  t.number("p84_speed", "84th percentile", "84th percentile" + speed, &S::speed_p84_mps, "mps");
  t.number("p95_speed", "95th percentile", "95th percentile" + speed, &S::speed_p95_mps, "mps");
  t.number("largest_speed", "Largest", "largest speed at the first crossing", &S::speed_largest_mps,
           "mps");
  const std::string energy = "kinetic energy of each kilogram at the ";
  t.number("median_energy", "Energy at the median", energy + "median speed",
           energy_jpkg(&S::speed_median_mps), "Jpkg");
  t.number("p84_energy", "Energy at the 84th percentile", energy + "84th percentile of the speed",
           energy_jpkg(&S::speed_p84_mps), "Jpkg");
  const std::string time = " time of the first crossing";
  t.number("p16_time", "16th percentile of time",
           "16th percentile of the" + time + " from the record's begin", &S::time_p16_s, "s");
  t.number("median_time", "Median time", "median" + time, &S::time_median_s, "s");
  t.number("p84_time", "84th percentile of time", "84th percentile of the" + time, &S::time_p84_s,
           "s");
  t.add_each(results.runs, &RunResults::impact);
  Table table = with_listed(results, t);
  table.add_note(open_percentile(results));
  return table;
}

Figure impact_figure(const Results& results, const RunResults& run) {
  Figure figure{
      "impact", "Speed of the array when it first reaches a clearance",
      "given that it is reached; " + counts_of(results) + "; " + friction_of(results, run),
      "Half its square is the energy in J that a parapet there must absorb for each kilogram that "
      "moves together. " +
          impact_explained() +
          " Points: median over all histories (records and samples together) that reach it, at "
          "three levels of intensity at most; bars: 16th to 84th percentile. Clearances that fewer "
          "than three records reach are left out at that level. Friction " +
          friction_and_listed(results, run) + "."};
  std::vector<double> levels;  // where there is anything to show
  for (const double level : results.levels)
    if (std::ranges::any_of(run.impact, [&](const ImpactStatistics& s) {
          return s.level == level && reached_by_enough(s.speed_median_mps.interval.low);
        }))
      levels.push_back(level);
  levels = some_levels(levels, most_levels);
  if (levels.empty()) return figure;
  View view{impact_table(results), "threshold", {}, {{"run", run.label}}};
  keep_rows(view.table, "median_speed_low95", reached_by_enough);
  for (const double level : levels)
    view.lines.push_back({"median at " + at_intensity(results, level),
                          family_look(view.lines.size(), levels.size()),
                          as_line_and_points,
                          "median_speed",
                          {{"level", level}},
                          "p16_speed",
                          "p84_speed"});
  const double right_m = 1.08 * (results.thresholds_m.empty() ? 1.0 : results.thresholds_m.back());
  view.spread = DataSeries::Kind::bars;
  view.spread_name = "16th to 84th percentile";
  view.apart = 0.006 * right_m;
  Panel panel{"", length_axis("Clearance: distance in plan from the initial position", right_m)};
  add_lines(panel, view);
  const double top_mps = largest_y(panel);
  panel.series.push_back({DataSeries::Kind::bars, look(Role::largest), "",
                          "bars: 16th to 84th percentile of the histories that reach it"});
  const double shown_mps = top_mps > 0.0 ? 1.08 * top_mps : 1.0;
  panel.y = {"Speed in plan, relative to the roof (m/s)", 0.0, shown_mps};
  figure.panels = {std::move(panel)};
  return figure;
}

namespace {

/// The first run at a handful of levels, where the array reaches it at all: for reading.
Table brief_impact_table(const Results& results) {
  const RunResults& run = results.runs.front();
  const std::vector<double> chosen = some_levels(results.levels, 5);
  Table table = impact_table(results);
  table.rows.resize(run.impact.size());
  keep_rows(table, "level", [&](double level) { return std::ranges::count(chosen, level) > 0; });
  keep_rows(table, "reached_share", [](double share) { return share > 0.0; });
  table.title = "Speed on first reaching a clearance, given that it is reached (" +
                friction_of(results, run) + "). Intensity measure: " + results.intensity_label +
                ".";
  return table.only({"threshold", "level", "reached_share", "median_speed", "p84_speed",
                     "p84_energy", "median_time"});
}

/// Speeds at a level, one sentence; empty where no history reaches it.
std::string impact_sentence(const Results& results, double level) {
  std::string speeds;
  for (const ImpactStatistics& s : results.runs.front().impact) {
    if (s.level != level || s.reached_share.value == 0.0) continue;
    speeds +=
        fmt::format("{}{} and {} m/s at {} ({} of the histories)", speeds.empty() ? "" : "; ",
                    format_number(s.speed_median_mps.value), format_number(s.speed_p84_mps.value),
                    format_length(s.threshold_m), format_share(s.reached_share.value));
  }
  if (speeds.empty()) return "";
  return fmt::format(
      "Where the array reaches a clearance at {}, it does so with these speeds (median and "
      "84th percentile): {}.",
      at_intensity(results, level), speeds);
}

Html section(const Results& results) {
  const Table table = brief_impact_table(results);
  return heading("Speed on reaching a parapet, given that it is reached") +
         paragraph(impact_explained()) +
         (table.rows.empty() ? paragraph("The array reached no clearance at these levels.")
                             : wide_table(table)) +
         paragraph("Every combination, clearance and level: tables/impact.csv.");
}

/// At the level nearest to 1 g.
std::vector<std::string> sentences(const Results& results) {
  const std::string sentence = impact_sentence(
      results, *std::ranges::min_element(results.levels, {},
                                         [](double level) { return std::abs(level - 1.0); }));
  if (sentence.empty()) return {};
  return {sentence};
}

}  // namespace

AnalysisReport ImpactAnalysis::in_report() {
  return {.is_in = has_impact,
          .sentences = sentences,
          .figures = [](const Results& r) { return std::vector{impact_figure(r, r.runs.front())}; },
          .tables = each<impact_table>,
          .section = section};
}
}  // namespace glissade
