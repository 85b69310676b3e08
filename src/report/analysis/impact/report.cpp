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

/// Kinetic energy of what moves at this speed, by its mass.
double energy_jpkg(double speed_mps) { return 0.5 * speed_mps * speed_mps; }

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
  Table table{"impact",
              "Speed and time at which the array is first displaced by a clearance. " +
                  impact_explained() + " Intensity measure: " + results.intensity_label + ".",
              {run_column,
               threshold_column,
               level_column(results),
               {"reached_share", "", "Reached [95 %]", ColumnKind::share,
                "share of histories that reach the threshold", true},
               {"p16_speed", "mps", "16th percentile, m/s", ColumnKind::number,
                "16th percentile of the speed at the first crossing"},
               {"median_speed", "mps", "Median speed, m/s [95 %]", ColumnKind::number,
                "median speed in plan at the first crossing, of the histories that reach it", true},
               {"p84_speed", "mps", "84th percentile, m/s [95 %]", ColumnKind::number,
                "84th percentile of the speed at the first crossing", true},
               {"p95_speed", "mps", "95th percentile, m/s", ColumnKind::number,
                "95th percentile of the speed at the first crossing"},
               {"largest_speed", "mps", "Largest, m/s", ColumnKind::number,
                "largest speed at the first crossing"},
               {"median_energy", "Jpkg", "Energy at the median, J/kg", ColumnKind::number,
                "kinetic energy of each kilogram at the median speed"},
               {"p84_energy", "Jpkg", "Energy at the 84th percentile, J/kg", ColumnKind::number,
                "kinetic energy of each kilogram at the 84th percentile of the speed"},
               {"p16_time", "s", "16th percentile of time, s", ColumnKind::number,
                "16th percentile of the time of the first crossing from the record's begin"},
               {"median_time", "s", "Median time, s", ColumnKind::number,
                "median time of the first crossing"},
               {"p84_time", "s", "84th percentile of time, s", ColumnKind::number,
                "84th percentile of the time of the first crossing"}},
              {}};
  for (const RunResults& run : results.runs) {
    for (const ImpactStatistics& s : run.impact) {
      table.add({run.label, s.threshold_m, s.level, s.reached_share, s.speed_p16_mps,
                 s.speed_median_mps, s.speed_p84_mps, s.speed_p95_mps, s.speed_largest_mps,
                 energy_jpkg(s.speed_median_mps.value), energy_jpkg(s.speed_p84_mps.value),
                 s.time_p16_s, s.time_median_s, s.time_p84_s});
    }
  }
  return with_listed(results, table);
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
          .figures =
              [](const Results& results) {
                return std::vector{impact_figure(results, results.runs.front())};
              },
          .tables = [](const Results& results) { return std::vector{impact_table(results)}; },
          .section = section};
}
}  // namespace glissade
