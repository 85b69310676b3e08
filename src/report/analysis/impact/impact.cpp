// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/impact/impact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/analyses.hpp"
#include "glissade/report/figures.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/tables.hpp"
#include "page/page.hpp"
#include "text/study_text.hpp"

namespace glissade {

bool has_impact(const Results& results) {
  return std::ranges::any_of(results.runs,
                             [](const RunResults& run) { return !run.impact.empty(); });
}

std::string impact_explained() {
  return "Each number is conditional on impact: histories that do not reach the "
         "clearance are left out, and the share that reaches it is given beside it. The speed is "
         "that of the array relative to the roof, in plan, when it is first displaced by the "
         "clearance. The kinetic energy (J) of each kilogram that moves together is half the "
         "square of the speed; a parapet there must absorb it. The histories slide on as if "
         "nothing stood there: a parapet that stops the array changes what follows.";
}

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

Table brief_impact_table(const Results& results) {
  const RunResults& run = results.runs.front();
  Table table{"impact_brief",
              "Speed on first reaching a clearance, given that it is reached (" +
                  friction_of(results, run) + "). Intensity measure: " + results.intensity_label +
                  ".",
              {threshold_column,
               level_column(results),
               {"reached_share", "", "Reached", ColumnKind::share,
                "share of histories that reach the threshold"},
               {"median_speed", "mps", "Median speed, m/s [95 %]", ColumnKind::number,
                "median speed in plan at the first crossing, of the histories that reach it", true},
               {"p84_speed", "mps", "84th percentile, m/s [95 %]", ColumnKind::number,
                "84th percentile of the speed at the first crossing", true},
               {"p84_energy", "Jpkg", "Energy at the 84th, J/kg", ColumnKind::number,
                "kinetic energy of each kilogram at the 84th percentile of the speed"},
               {"median_time", "s", "Median time, s", ColumnKind::number,
                "median time of the first crossing"}},
              {}};
  const std::vector<double> chosen = some_levels(results.levels, 5);
  for (const ImpactStatistics& s : run.impact) {
    if (s.reached_share.value == 0.0 || !std::ranges::count(chosen, s.level)) continue;
    table.add({s.threshold_m, s.level, s.reached_share.value, s.speed_median_mps, s.speed_p84_mps,
               energy_jpkg(s.speed_p84_mps.value), s.time_median_s});
  }
  return table;
}

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

namespace {

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
