// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "glissade/report/figures.hpp"
#include "glissade/report/format.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

/// What one standard prescribes: a line, points where it was checked, hollow where it was recalled.
void add_standard(Panel& panel, const RunResults& run, Standard standard, Look style,
                  int hollow_symbol) {
  const std::string name = standard_name(standard);
  DataSeries all{DataSeries::Kind::line, style, name};
  for (const StandardComparison& c : run.standards) {
    if (c.standard != standard) continue;
    all.add(c.sds_g, c.prescribed.value_m);
  }
  if (all.x.empty()) return;
  panel.series.push_back(all);
  for (const Provenance provenance : {Provenance::checked, Provenance::recalled}) {
    const bool recalled = provenance == Provenance::recalled;
    Look look = style;
    if (recalled) look.symbol = hollow_symbol;
    DataSeries points{DataSeries::Kind::points, look,
                      name + (recalled ? ", recalled" : ", checked")};
    for (const StandardComparison& c : run.standards) {
      if (c.standard != standard || c.prescribed.provenance != provenance) continue;
      points.add(c.sds_g, c.prescribed.value_m);
    }
    if (points.x.empty()) continue;
    panel.series.push_back(points);
  }
  panel.series.push_back({DataSeries::Kind::line_and_points, style, "", name});
}

struct Statistic {
  Role role;
  const char* label;
  double SlipStatistics::*value_m;
  Interval SlipStatistics::*interval;
};

/// The band of a statistic's interval below all, its line above.
void add_statistic(Panel& panel, const RunResults& run, const Statistic& statistic) {
  DataSeries line{DataSeries::Kind::line, look(statistic.role), statistic.label, statistic.label};
  DataSeries band{DataSeries::Kind::band, line.look, std::string(statistic.label) + ": band"};
  for (const SlipStatistics& s : run.slip) {
    line.add(s.level, s.*statistic.value_m);
    if (statistic.interval) band.add(s.level, s.*statistic.interval);
  }
  panel.series.insert(panel.series.begin(), std::move(band));
  panel.series.push_back(std::move(line));
}

}  // namespace

Figure slip_vs_sds_figure(const Results& results, const RunResults& run) {
  const bool has_standards = !run.standards.empty();
  Figure figure{"slip_vs_sds",
                std::string("Slip at increasing design intensity") +
                    (has_standards ? ", and what the standards prescribe" : ""),
                counts_of(results) + "; " + friction_of(results, run),
                "Peak slip in plan over all histories at each S_DS: median, 84th and 95th "
                "percentile and mean; shaded: 95 % intervals of the median and of the 84th "
                "percentile from resampling whole records. Friction " +
                    run.friction_description + "."};
  if (has_standards) {
    figure.caption +=
        " On the right: displacements prescribed by the standards; hollow points rest on "
        "provisions recalled from memory and must be verified against the standard. Values: "
        "tables/standards.csv.";
  }
  figure.labels_at_lines = true;
  double top_m = 0.0, prescribed_m = 0.0;
  for (const SlipStatistics& s : run.slip) {
    for (const double slip_m : {s.median_m, s.p84_m, s.p95_m, s.mean_m})
      if (std::isfinite(slip_m)) top_m = std::max(top_m, slip_m);  // infinite: not run
  }
  for (const StandardComparison& c : run.standards)
    prescribed_m = std::max(prescribed_m, c.prescribed.value_m);
  const auto panel_to = [&](const char* title, double high_m) {
    return Panel{title,
                 {results.intensity_label, 0.0, results.levels.back()},
                 length_axis("Peak slip in plan", high_m > 0.0 ? 1.05 * high_m : 1.0)};
  };
  const Statistic p95{Role::p95, "95th", &SlipStatistics::p95_m, nullptr},
      p84{Role::p84, "84th", &SlipStatistics::p84_m, &SlipStatistics::p84_interval},
      mean{Role::mean, "mean", &SlipStatistics::mean_m, nullptr},
      median{Role::median, "median", &SlipStatistics::median_m, &SlipStatistics::median_interval};
  Panel slip = panel_to("Slip", top_m);
  for (const Statistic& statistic : {p95, p84, mean, median}) add_statistic(slip, run, statistic);
  figure.panels.push_back(std::move(slip));
  if (!has_standards) return figure;
  Panel compared = panel_to("Slip and prescribed displacements", std::max(top_m, prescribed_m));
  Statistic median_line = median;
  median_line.interval = nullptr;
  for (const Statistic& statistic : {p95, median_line}) add_statistic(compared, run, statistic);
  // The two standards agree over a wide range: the wide line is drawn below the narrow one.
  add_standard(compared, run, Standard::asce7_16, {{0x999999}, 5.0, 1, 5, 1.5}, 4);
  add_standard(compared, run, Standard::seaoc_pv1_2012, {{0x5e3c99}, 1.5, 5, 7, 0.8}, 6);
  figure.panels.push_back(std::move(compared));
  return figure;
}

}  // namespace glissade
